// SPDX-License-Identifier: BSD-3-Clause
// S9: border lengths in one sweep, then the test.
#include "inverse_depth/thickness.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace epcc {

namespace {

constexpr double kHoleEdge = 0.25;  // a hole says little about where a surface ends
constexpr double kMinChi2 = 0.05;   // of a sensor model that is far too wide
constexpr double kPower = 0.6;
constexpr double kSamplesOfUnit = 30.0;      // a region of so many independent samples needs min_thickness
constexpr double kMaxPixelsPerSample = 100;  // else long blotches would excuse anything

/// Border of each label, in edges of the grid.
std::vector<double> borderLengths(const InverseDepthImage& image, const RegionMap& map) {
  std::vector<double> length(map.regions.size() + 1, 0.0);
  const auto meet = [&](std::size_t a, std::size_t b) {
    const std::int32_t label_a = map.labels[a], label_b = map.labels[b];
    if (label_a == label_b) return;
    length[static_cast<std::size_t>(label_a)] += image.w[b] > 0.0f ? 1.0 : kHoleEdge;
    length[static_cast<std::size_t>(label_b)] += image.w[a] > 0.0f ? 1.0 : kHoleEdge;
  };
  const auto width = static_cast<std::size_t>(image.width);
  for (int row = 0; row < image.height; ++row)
    for (int column = 0; column < image.width; ++column) {
      const std::size_t pixel = image.index(row, column);
      if (column + 1 < image.width) meet(pixel, pixel + 1);
      if (row + 1 < image.height) meet(pixel, pixel + width);
    }
  return length;
}

}  // namespace

void rejectThin(const InverseDepthImage& image, const InverseDepthParameters& parameters, const SensorModel& sensor,
                int stride, RegionMap& map) {
  const double min_thickness = parameters.expert.evidence.min_thickness;
  if (min_thickness <= 0.0) return;
  const std::vector<double> border = borderLengths(image, map);
  const double pixels_per_sample = std::min(sensor.pixelsPerSample(), kMaxPixelsPerSample / (stride * stride));
  std::vector<std::int32_t> new_label(map.regions.size() + 1, 0);
  for (std::size_t k = 0; k < map.regions.size(); ++k) {
    PlaneMoments& region = map.regions[k];
    if (region.n <= 0.0) continue;
    const RegionPlane plane(region);
    const double chi2 = std::max(kMinChi2, plane.rss / (region.n * plane.slope_factor));
    const double thickness = stride * region.n / std::max(border[k + 1], 1e-9);
    const double samples = region.n / pixels_per_sample;
    if (thickness >= min_thickness * std::pow(chi2, kPower) * std::pow(samples / kSamplesOfUnit, -kPower))
      new_label[k + 1] = static_cast<std::int32_t>(k + 1);
    else
      region = PlaneMoments();
  }
  map.relabel(new_label);
}

}  // namespace epcc
