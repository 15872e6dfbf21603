// SPDX-License-Identifier: BSD-3-Clause
// Blocks binned by the logarithm of their depth, and what the bins tell.
#include "sensor/depth_bins.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "quantile.h"

namespace epcc {

namespace {

constexpr std::size_t kMinBlocksPerBin = 4;
constexpr double kDepthBinsPerOctave = 3.0;
constexpr double kLowQuantile = 0.2;
// Of the blocks' terms of second order: the lowest tenth of a chi square of three degrees of freedom, over the three.
constexpr double kStraightest = 0.1;
constexpr double kBentByChance = 0.195;
constexpr double kClutteredBin = 1.5;    // in medians of deviation / sigma over the bins
constexpr double kClutteredBlock = 2.0;  // in deviations of its bin
constexpr double kClutterGuard = 1.1;
// Blocks agree if their median is no larger, in low quantiles, than the chance of three degrees of freedom makes it:
// the residuals of a block have more. A bin of fewer blocks says nothing, for its low quantile is that of one or two.
constexpr double kAgree = 1.5;
constexpr std::size_t kFewestThatAgree = 10;
constexpr double kNearby = 0.2;  // octaves

}  // namespace

DepthBins::DepthBins() {
  places_.reserve(kMaxBlocks);
  bins_.reserve(kMaxBlocks / kMinBlocksPerBin);
  values_.reserve(kMaxBlocks);
}

void DepthBins::sort(const std::vector<BlockResiduals>& blocks) {
  blocks_ = &blocks;
  places_.clear();
  bins_.clear();
  if (blocks.empty()) return;
  double log_depth = 0.0;
  for (const BlockResiduals& block : blocks) log_depth += std::log2(block.depth);
  // One bin is about the mean depth, so that the unit of length does not matter.
  const double first = log_depth / static_cast<double>(blocks.size()) - 0.5 / kDepthBinsPerOctave;
  for (std::size_t i = 0; i < blocks.size(); ++i)
    places_.push_back({static_cast<int>(std::floor(kDepthBinsPerOctave * (std::log2(blocks[i].depth) - first))),
                       static_cast<int>(i)});
  std::sort(places_.begin(), places_.end());
  for (std::size_t begin = 0, end; begin < places_.size(); begin = end) {
    for (end = begin + 1; end < places_.size() && places_[end].bin == places_[begin].bin;) ++end;
    if (end - begin < kMinBlocksPerBin) continue;
    DepthBin bin;
    bin.begin = begin;
    bin.end = end;
    describe(bin);
    bins_.push_back(bin);
  }
}

void DepthBins::describe(DepthBin& bin) {
  double log_depth = 0.0;
  values_.clear();
  for (std::size_t i = bin.begin; i < bin.end; ++i) {
    log_depth += std::log(block(i).depth);
    values_.push_back(block(i).step);
  }
  bin.depth = std::exp(log_depth / bin.weight());
  bin.step = quantile(values_, 0.5);
}

std::size_t DepthBins::blockCount() const {
  std::size_t count = 0;
  for (const DepthBin& bin : bins_) count += bin.end - bin.begin;
  return count;
}

void DepthBins::findDeviations(const SigmaShape& sigma, double axial) {
  for (DepthBin& bin : bins_) {
    values_.clear();
    for (std::size_t i = bin.begin; i < bin.end; ++i)
      values_.push_back(block(i).deviationAlong(axial) / sigma(block(i).depth));
    const double low = quantile(values_, kLowQuantile);
    bin.deviation = low * sigma(bin.depth);
    bin.agrees = bin.end - bin.begin >= kFewestThatAgree && quantile(values_, 0.5) <= kAgree * low;
  }
}

/// Of the deviations in sigmas of the bins that do not hold little but clutter.
double DepthBins::clutterLimit(const SigmaShape& sigma) {
  values_.clear();
  for (const DepthBin& bin : bins_) values_.push_back(bin.deviation / sigma(bin.depth));
  return kClutteredBin * quantile(values_, 0.5);
}

std::array<double, kScales - 1> DepthBins::kept(const SigmaShape& sigma, double axial) {
  assert(!bins_.empty());
  const double limit = clutterLimit(sigma);
  std::array<double, kScales - 1> result{};
  for (std::size_t scale = 0; scale + 1 < kScales; ++scale) {
    values_.clear();
    for (const DepthBin& bin : bins_) {
      const double size = bin.deviation / sigma(bin.depth);
      if (size > limit) continue;
      for (std::size_t i = bin.begin; i < bin.end; ++i)
        if (block(i).deviationAlong(axial) <= kClutteredBlock * size * sigma(block(i).depth))
          values_.push_back(block(i).kept[scale]);
    }
    assert(!values_.empty());  // the median bin is asked, and a fifth of its blocks
    result[scale] = quantile(values_, 0.5);
  }
  return result;
}

double DepthBins::bentOverChance() {
  assert(!bins_.empty());
  values_.clear();
  for (const DepthBin& bin : bins_)
    for (std::size_t i = bin.begin; i < bin.end; ++i) values_.push_back(block(i).bent);
  return quantile(values_, kStraightest) / kBentByChance;
}

void DepthBins::guardAgainstClutter(const std::vector<BlockResiduals>& halves, double axial, double kept) {
  const double nearby = std::exp2(kNearby);
  for (DepthBin& bin : bins_) {
    if (bin.agrees) continue;
    values_.clear();
    for (const BlockResiduals& half : halves)
      if (half.depth < bin.depth * nearby && half.depth * nearby > bin.depth)
        values_.push_back(half.deviationAlong(axial));
    if (values_.size() < kMinBlocksPerBin) continue;
    bin.deviation = std::min(bin.deviation, kClutterGuard * quantile(values_, kLowQuantile) / std::sqrt(kept));
  }
}

}  // namespace epcc
