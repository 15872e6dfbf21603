// SPDX-License-Identifier: BSD-3-Clause
// Pixels are counted by the labels that they have in both frames.
#include "eval/measures/lasting_labels.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace epcc {
namespace {

constexpr std::size_t kWatchedSurfaces = 5;
constexpr double kChi2Limit = 7.814728;  // 95 % of chi^2 of three degrees of freedom
constexpr double kMostCounted = 1e6;

/// Shared pixels by labels: of the first frame, of the second, and of both.
struct PairCounts {
  std::map<int, long> from, to;
  std::map<std::pair<int, int>, long> both;
  long shared = 0;
};

PairCounts countPairs(const std::vector<std::int32_t>& shared, const LastingRegions& from, const LastingRegions& to) {
  long* count = nullptr;  // neighbours mostly have the same pair of labels
  std::pair<int, int> last;
  PairCounts counts;
  for (std::size_t i = 0; i < shared.size(); ++i) {
    if (shared[i] < 0) continue;
    ++counts.shared;
    const std::pair<int, int> pair(from.labels.data[i], to.labels.data[static_cast<std::size_t>(shared[i])]);
    if (count == nullptr || pair != last) count = &counts.both[pair];
    last = pair;
    ++*count;
  }
  for (const auto& [pair, pixels] : counts.both) {
    counts.from[pair.first] += pixels;
    counts.to[pair.second] += pixels;
  }
  return counts;
}

bool isFlat(const LastingRegions& regions, int label) {
  const auto found = regions.flat.find(label);
  return found != regions.flat.end() && found->second;
}

/// The label with the most pixels, the smallest of equal ones; `most` pixels.
int mostFrequent(const std::map<int, long>& counts, long& most) {
  int best = 0;
  most = 0;
  for (const auto& [label, pixels] : counts)
    if (pixels > most) {
      most = pixels;
      best = label;
    }
  return best;
}

}  // namespace

LastingRegions lastingRegions(const SeenRegions& regions, const std::vector<std::int32_t>& label_of_plane) {
  if (label_of_plane.size() != regions.planes.size()) throw std::invalid_argument("each plane needs a label");
  LastingRegions lasting;
  lasting.labels = LabelImage(regions.labels.width, regions.labels.height);
  std::vector<long> pixels(regions.planes.size() + 1);
  for (std::size_t i = 0; i < regions.labels.data.size(); ++i) {
    const std::uint16_t plane = regions.labels.data[i];
    ++pixels[plane];
    if (plane > 0) lasting.labels.data[i] = static_cast<std::uint16_t>(label_of_plane[plane - 1U]);
  }
  std::map<int, long> largest;
  for (std::size_t plane = 1; plane < pixels.size(); ++plane) {
    const int label = label_of_plane[plane - 1];
    if (label == 0 || pixels[plane] <= largest[label]) continue;
    largest[label] = pixels[plane];
    lasting.flat[label] = regions.flat[plane];
  }
  return lasting;
}

LastingRepeatability& LastingRepeatability::operator+=(const LastingRepeatability& other) {
  pairs += other.pairs;
  shared += other.shared;
  repeated_pixels += other.repeated_pixels;
  regions += other.regions;
  repeated += other.repeated;
  return *this;
}

LastingRepeatability lastingRepeatability(const std::vector<std::int32_t>& shared, const LastingRegions& from,
                                          const LastingRegions& to) {
  const PairCounts counts = countPairs(shared, from, to);
  LastingRepeatability result;
  result.pairs = 1;
  result.shared = counts.shared;
  for (const auto& [label, pixels] : counts.from) {
    if (label == 0 || pixels < kMinSharedPixels || !isFlat(from, label)) continue;
    ++result.regions;
    const auto both = counts.both.find({label, label});
    if (both == counts.both.end() || !isFlat(to, label)) continue;
    const long overlap = 100 * both->second;
    if (overlap < kRepeatedPercent * pixels || overlap < kRepeatedPercent * counts.to.at(label)) continue;
    ++result.repeated;
    result.repeated_pixels += pixels;
  }
  return result;
}

void SwitchCounter::add(const LabelImage& truth, const LabelImage& labels, double time) {
  if (truth.data.size() != labels.data.size()) throw std::invalid_argument("truth and labels differ in size");
  std::map<int, std::map<int, long>> counts;
  for (std::size_t i = 0; i < truth.data.size(); ++i)
    if (truth.data[i] != 0 && truth.data[i] != kIgnoreLabel) ++counts[truth.data[i]][labels.data[i]];
  for (const auto& [surface, by_label] : counts) {
    long pixels = 0, most = 0;
    for (const auto& entry : by_label) pixels += entry.second;
    const int label = mostFrequent(by_label, most);
    if (pixels < kMinSharedPixels || label == 0) continue;
    const auto [last, is_new] = last_.emplace(surface, Last{label, time});
    if (!is_new) {
      result_.seconds += time - last->second.time;
      result_.switches += last->second.label == label ? 0 : 1;
    }
    last->second = {label, time};
  }
}

LabelSwitches labelSwitches(const std::vector<std::int32_t>& shared, const LastingRegions& from,
                            const LastingRegions& to, double seconds) {
  const PairCounts counts = countPairs(shared, from, to);
  std::vector<std::pair<long, int>> largest;
  for (const auto& [label, pixels] : counts.from)
    if (label != 0 && pixels >= kMinSharedPixels) largest.emplace_back(-pixels, label);
  std::sort(largest.begin(), largest.end());
  largest.resize(std::min(largest.size(), kWatchedSurfaces));
  LabelSwitches result;
  for (const auto& [negative_pixels, label] : largest) {
    std::map<int, long> there;
    for (auto it = counts.both.lower_bound({label, 0}); it != counts.both.end() && it->first.first == label; ++it)
      there[it->first.second] = it->second;
    long most = 0;
    const int held_by = mostFrequent(there, most);
    if (held_by == 0) continue;
    result.seconds += seconds;
    result.switches += held_by == label ? 0 : 1;
  }
  return result;
}

void SquaredErrors::add(double squared_error) {
  if (!(squared_error >= 0.0)) return;
  const double counted = std::min(squared_error, kMostCounted);
  values_.add(std::lround(1e3 * counted));
  sum_ += counted;
  within_ += squared_error <= kChi2Limit ? 1 : 0;
}

double SquaredErrors::mean() const {
  return size() > 0 ? sum_ / static_cast<double>(size()) : 0.0;
}

double SquaredErrors::median() const {
  return 1e-3 * values_.median().value_or(0.0);
}

double SquaredErrors::shareWithinLimit() const {
  return size() > 0 ? static_cast<double>(within_) / static_cast<double>(size()) : 0.0;
}

}  // namespace epcc
