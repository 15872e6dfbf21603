// SPDX-License-Identifier: BSD-3-Clause
// Blocks binned by the logarithm of their depth, and what the bins tell.
#include "sensor/depth_bins.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "sensor/quantile.h"

namespace epcc {

namespace {

constexpr std::size_t kMinBlocksPerBin = 4;
constexpr double kBinsPerOctave = 3.0;
constexpr double kLowQuantile = 0.2;
constexpr double kClutteredBin = 3.0;  // in medians of r / z^2 over the bins
constexpr double kClutterGuard = 1.1;

double inverseDepthResidual(const DepthBin& bin) {
  return bin.deviation / (bin.depth * bin.depth);
}

}  // namespace

DepthBins::DepthBins() {
  places_.reserve(kMaxBlocks);
  bins_.reserve(kMaxBlocks / kMinBlocksPerBin);
  values_.reserve(2 * kMaxBlocks);
}

void DepthBins::sort(const std::vector<PlacedBlock>& blocks) {
  blocks_ = &blocks;
  places_.clear();
  bins_.clear();
  for (std::size_t i = 0; i < blocks.size(); ++i)
    places_.push_back(
        {static_cast<int>(std::floor(kBinsPerOctave * std::log2(blocks[i].residuals.depth))), static_cast<int>(i)});
  std::sort(places_.begin(), places_.end());
  for (std::size_t begin = 0, end; begin < places_.size(); begin = end) {
    for (end = begin + 1; end < places_.size() && places_[end].bin == places_[begin].bin;) ++end;
    if (end - begin < kMinBlocksPerBin) continue;
    DepthBin bin;
    bin.begin = begin;
    bin.end = end;
    summarize(bin);
    if (bin.deviation > 0.0) bins_.push_back(bin);
  }
}

void DepthBins::summarize(DepthBin& bin) {
  bin.weight = static_cast<double>(bin.end - bin.begin);
  double log_depth = 0.0;
  values_.clear();
  for (std::size_t i = bin.begin; i < bin.end; ++i) {
    log_depth += std::log(block(i).residuals.depth);
    values_.push_back(block(i).residuals.deviation);
  }
  bin.depth = std::exp(log_depth / bin.weight);
  bin.deviation = quantile(values_, kLowQuantile);
  values_.clear();
  for (std::size_t i = bin.begin; i < bin.end; ++i) values_.push_back(block(i).residuals.step);
  bin.step = quantile(values_, 0.5);
}

std::size_t DepthBins::blockCount() const {
  std::size_t count = 0;
  for (const DepthBin& bin : bins_) count += bin.end - bin.begin;
  return count;
}

/// Of r / z^2 of the bins that do not hold little but clutter, whose outlines look like blotches.
double DepthBins::clutterLimit() {
  values_.clear();
  for (const DepthBin& bin : bins_) values_.push_back(inverseDepthResidual(bin));
  return kClutteredBin * quantile(values_, 0.5);
}

double DepthBins::correlationAt(std::size_t lag, double roughest, double clutter_limit) {
  double sum = 0.0;
  double weight = 0.0;
  for (const DepthBin& bin : bins_) {
    if (inverseDepthResidual(bin) > clutter_limit) continue;
    values_.clear();
    for (std::size_t i = bin.begin; i < bin.end; ++i)
      if (block(i).residuals.deviation < roughest * bin.deviation)
        values_.push_back(block(i).residuals.correlation[lag]);
    if (values_.empty()) continue;
    sum += bin.weight * quantile(values_, 0.5);
    weight += bin.weight;
  }
  return weight > 0.0 ? sum / weight : 0.0;
}

std::array<double, kLags.size()> DepthBins::correlation(double roughest) {
  assert(!bins_.empty());
  const double limit = clutterLimit();
  std::array<double, kLags.size()> result{};
  for (std::size_t k = 0; k < kLags.size(); ++k) result[k] = correlationAt(k, roughest, limit);
  return result;
}

void DepthBins::guardAgainstClutter() {
  for (DepthBin& bin : bins_) {
    values_.clear();
    for (std::size_t i = bin.begin; i < bin.end; ++i)
      for (const double deviation : block(i).half_deviations)
        if (deviation != kUnmeasured) values_.push_back(deviation);
    if (values_.size() >= kMinBlocksPerBin)
      bin.deviation = std::min(bin.deviation, kClutterGuard * quantile(values_, kLowQuantile));
  }
}

}  // namespace epcc
