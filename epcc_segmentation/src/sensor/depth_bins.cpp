// SPDX-License-Identifier: BSD-3-Clause
// Blocks spread over the image, binned by the logarithm of their depth.
#include "sensor/depth_bins.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>

#include "sensor/quantile.h"

namespace epcc {

namespace {

constexpr int kMaxBlocks = 120;
constexpr std::size_t kMinBlocksPerBin = 4;
constexpr double kBinsPerOctave = 3.0;
constexpr double kLowQuantile = 0.2;
constexpr double kClutteredBin = 3.0;  // in medians of r / z^2 over the bins
constexpr double kClutterGuard = 1.1;

std::vector<PlacedBlock> measureBlocks(const InverseDepthImage& image, int size) {
  std::vector<PlacedBlock> blocks;
  const int across = image.width / size;
  const int down = image.height / size;
  const int tiles = across * down;
  const int count = std::min(tiles, kMaxBlocks);
  for (int i = 0; i < count; ++i) {
    const int tile = static_cast<int>(static_cast<long>(i) * tiles / count);
    const int row = tile / across * size;
    const int column = tile % across * size;
    if (const auto block = measureBlock(image, row, column, size)) blocks.push_back({row, column, *block});
  }
  return blocks;
}

void summarize(DepthBin& bin) {
  std::vector<double> r, steps;
  double log_depth = 0.0;
  for (const auto& block : bin.blocks) {
    r.push_back(block.residuals.deviation);
    steps.push_back(block.residuals.step);
    log_depth += std::log(block.residuals.depth);
  }
  bin.weight = static_cast<double>(bin.blocks.size());
  bin.depth = std::exp(log_depth / bin.weight);
  bin.deviation = quantile(r, kLowQuantile);
  bin.step = quantile(steps, 0.5);
}

double inverseDepthResidual(const DepthBin& bin) {
  return bin.deviation / (bin.depth * bin.depth);
}

/// Without the bins that hold little but clutter, whose outlines look like blotches.
std::vector<DepthBin> clearBins(const std::vector<DepthBin>& bins) {
  std::vector<double> residuals;
  for (const auto& bin : bins) residuals.push_back(inverseDepthResidual(bin));
  const double limit = kClutteredBin * quantile(residuals, 0.5);
  std::vector<DepthBin> clear;
  for (const auto& bin : bins)
    if (inverseDepthResidual(bin) <= limit) clear.push_back(bin);
  return clear;
}

double correlationAt(const std::vector<DepthBin>& bins, std::size_t lag, double roughest) {
  double sum = 0.0;
  double weight = 0.0;
  for (const auto& bin : bins) {
    std::vector<double> values;
    for (const auto& block : bin.blocks)
      if (block.residuals.deviation < roughest * bin.deviation) values.push_back(block.residuals.correlation[lag]);
    if (values.empty()) continue;
    sum += bin.weight * quantile(values, 0.5);
    weight += bin.weight;
  }
  return weight > 0.0 ? sum / weight : 0.0;
}

}  // namespace

std::vector<DepthBin> measureDepthBins(const InverseDepthImage& image, int block_size) {
  std::map<int, DepthBin> bins;
  for (const auto& block : measureBlocks(image, block_size))
    bins[static_cast<int>(std::floor(kBinsPerOctave * std::log2(block.residuals.depth)))].blocks.push_back(block);
  std::vector<DepthBin> usable;
  for (auto& [index, bin] : bins) {
    if (bin.blocks.size() < kMinBlocksPerBin) continue;
    summarize(bin);
    if (bin.deviation > 0.0) usable.push_back(bin);
  }
  return usable;
}

std::array<double, kLags.size()> correlationOf(const std::vector<DepthBin>& bins, double roughest) {
  assert(!bins.empty());
  std::array<double, kLags.size()> correlation{};
  const auto clear = clearBins(bins);
  for (std::size_t k = 0; k < kLags.size(); ++k) correlation[k] = correlationAt(clear, k, roughest);
  return correlation;
}

void guardAgainstClutter(const InverseDepthImage& image, int block_size, std::vector<DepthBin>& bins) {
  const int half = block_size / 2;
  for (auto& bin : bins) {
    std::vector<double> r;
    for (const auto& block : bin.blocks)
      for (const int shift : {0, half})
        if (const auto error = measureBlockError(image, block.row + shift, block.column + shift, half))
          r.push_back(*error);
    if (r.size() >= kMinBlocksPerBin)
      bin.deviation = std::min(bin.deviation, kClutterGuard * quantile(r, kLowQuantile));
  }
}

}  // namespace epcc
