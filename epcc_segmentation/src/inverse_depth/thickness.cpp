// SPDX-License-Identifier: BSD-3-Clause
// S9: border lengths in one sweep, then the test.
#include "inverse_depth/thickness.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "parallel_for.h"

namespace epcc {

namespace {

constexpr double kHoleEdge = 0.25;  // a hole says little about where a surface ends
constexpr double kMinChi2 = 0.05;   // of a sensor model that is far too wide
constexpr double kPower = 0.6;
constexpr double kThickness = 4.0;        // a region of kSamplesOfUnit and chi^2 = 1 has a score of 1 at so many pixels
constexpr double kColumnsOfUnit = 640.0;  // thickness is in pixels of an image so wide
constexpr double kSamplesOfUnit = 30.0;   // independent samples
constexpr double kMaxPixelsPerSample = 100;  // else long blotches would excuse anything

/// Border of each label, in edges of the grid: of some rows.
class BorderLengths {
 public:
  BorderLengths(const InverseDepthImage& image, const RegionMap& map, ThicknessMemory::Sweep& memory)
      : image_(image), labels_(map.labels.data()), memory_(memory) {}

  void addRow(int row) {
    markLeftBorders(labels_, image_.width, image_.height, row, memory_.left);
    markUpperBorders(labels_, image_.width, row, memory_.above);
    const std::size_t start = image_.index(row, 0);
    const auto visit = [&](const RowBits& bits, std::size_t step) {
      memory_.pixels.clear(image_.width);
      for (std::size_t word = 0; word < bits.size(); ++word) memory_.pixels.add(bits[word], word);
      for (const int column : memory_.pixels) meet(start + static_cast<std::size_t>(column), step);
    };
    visit(memory_.left, 1);
    visit(memory_.above, static_cast<std::size_t>(image_.width));
  }

 private:
  void meet(std::size_t pixel, std::size_t step) {
    const std::size_t before = pixel - step;
    lengthOf(labels_[pixel]) += image_.w[before] > 0.0f ? 1.0 : kHoleEdge;
    lengthOf(labels_[before]) += image_.w[pixel] > 0.0f ? 1.0 : kHoleEdge;
  }
  double& lengthOf(std::int32_t label) { return memory_.border[static_cast<std::size_t>(label)]; }

  const InverseDepthImage& image_;
  const std::int32_t* labels_;
  ThicknessMemory::Sweep& memory_;
};

/// Those of all rows, per label. Sums of quarters are exact: who adds them up is of no importance.
const std::vector<double>& borderLengths(const InverseDepthImage& image, const RegionMap& map, ThicknessMemory& memory,
                                         int threads) {
  memory.sweeps.resize(static_cast<std::size_t>(std::max(1, threads)));
  for (ThicknessMemory::Sweep& sweep : memory.sweeps) {
    sweep.border.assign(map.regions.size() + 1, 0.0);
    sweep.pixels.clear(image.width);
    for (RowBits* bits : {&sweep.left, &sweep.above}) bits->assign(wordsOf(image.width), 0);
  }
  sharedFor(image.height, threads, [&](int thread, int begin, int end) {
    BorderLengths lengths(image, map, memory.sweeps[static_cast<std::size_t>(thread)]);
    for (int row = begin; row < end; ++row) lengths.addRow(row);
  });
  std::vector<double>& all = memory.sweeps.front().border;
  for (std::size_t thread = 1; thread < memory.sweeps.size(); ++thread)
    for (std::size_t k = 0; k < all.size(); ++k) all[k] += memory.sweeps[thread].border[k];
  return all;
}

/// The share of surfaces among the regions of this score, thickness over what is needed: a logistic curve of its
/// logarithm, fitted to the regions that all steps before leave on Kinect, ABW and ICL frames.
double confidence(double thickness, double needed) {
  constexpr double kSteepness = 1.5, kOddsOfUnit = 0.4;
  const double a = kOddsOfUnit * std::pow(thickness, kSteepness);
  const double b = std::pow(needed, kSteepness);
  return a / (a + b);
}

}  // namespace

void rejectThin(const InverseDepthImage& image, const InverseDepthParameters& parameters, const SensorModel& sensor,
                const GridSteps& steps, RegionMap& map, ThicknessMemory& memory, int threads) {
  const std::vector<double>& border = borderLengths(image, map, memory, threads);
  // A finer image of the same scene has as many pixels more in its thickness.
  const double unit = std::max(steps.across * image.width, steps.along * image.height) / kColumnsOfUnit;
  const double pixels_per_sample = std::min(sensor.pixelsPerSample(), kMaxPixelsPerSample / steps.area());
  const auto confidenceOf = [&](const PlaneMoments& region, double length) {
    const RegionPlane plane(region);
    const double chi2 = std::max(kMinChi2, plane.rss / (region.n * plane.slope_factor));
    const double samples = region.n / pixels_per_sample;
    const double needed = kThickness * std::pow(chi2, kPower) * std::pow(samples / kSamplesOfUnit, -kPower);
    return confidence(steps.side() * region.n, unit * length * needed);
  };
  memory.kept.clear();
  for (std::size_t k = 0; k < map.regions.size(); ++k) {
    const PlaneMoments& region = map.regions[k];
    if (!(region.n > 0.0)) continue;
    const bool is_known = static_cast<int>(k) < map.known;
    const double sure = is_known && map.doubtful[k] != 0 ? 0.0 : confidenceOf(region, border[k + 1]);
    if (is_known || sure >= parameters.min_confidence) memory.kept.push_back({region, k, sure});
  }
  std::sort(memory.kept.begin(), memory.kept.end(), [](const auto& a, const auto& b) {
    return a.region.n != b.region.n ? a.region.n > b.region.n : a.index < b.index;
  });
  memory.new_label.assign(map.regions.size() + 1, 0);
  map.regions.clear();
  map.confidence.clear();
  map.known_plane.clear();
  for (const ThicknessMemory::Kept& kept : memory.kept) {
    map.regions.push_back(kept.region);
    map.confidence.push_back(kept.confidence);
    map.known_plane.push_back(static_cast<int>(kept.index) < map.known ? static_cast<int>(kept.index) : -1);
    memory.new_label[kept.index + 1] = static_cast<std::int32_t>(map.regions.size());
  }
  map.relabel(memory.new_label, threads);
}

}  // namespace epcc
