// SPDX-License-Identifier: BSD-3-Clause
// Blocks -> depth bins -> class and correlation length -> sigma_z(z); and the same over a stream.
#include "epcc_segmentation/sensor_estimation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "sensor/block_residuals.h"

namespace epcc {

namespace {

constexpr int kMostBlocks = 120;
constexpr std::size_t kFewestPerBin = 4;
constexpr double kBinsPerOctave = 3.0;
constexpr double kLowQuantile = 0.2;  // clutter only enlarges residuals
constexpr double kFlatBlock = 1.5;    // blocks up to this many r_bin tell the correlation
constexpr double kClutterGuard = 1.1;
constexpr double kSigmaOverResidual = 2.9;  // the residual of a block misses what is correlated beyond it
constexpr double kPinball = 0.3;
constexpr double kHeaviestBin = 20.0;
constexpr int kGrid = 33;

struct PlacedBlock {
  int row, column;
  BlockResiduals residuals;
};

struct DepthBin {
  double depth = 0.0;  // geometric mean
  double r = 0.0;
  double weight = 0.0;
  std::vector<const PlacedBlock*> blocks;
};

double quantile(std::vector<double> values, double share) {
  const auto at = values.begin() + static_cast<long>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

std::vector<PlacedBlock> measureBlocks(const InverseDepthImage& image, int size) {
  std::vector<PlacedBlock> blocks;
  const int across = image.width / size;
  const int down = image.height / size;
  const int tiles = across * down;
  const int count = std::min(tiles, kMostBlocks);
  for (int i = 0; i < count; ++i) {
    const int tile = static_cast<int>(static_cast<long>(i) * tiles / count);
    const int row = tile / across * size;
    const int column = tile % across * size;
    if (const auto block = measureBlock(image, row, column, size)) blocks.push_back({row, column, *block});
  }
  return blocks;
}

std::vector<DepthBin> binByDepth(const std::vector<PlacedBlock>& blocks) {
  std::map<int, DepthBin> bins;
  for (const auto& block : blocks)
    bins[static_cast<int>(std::floor(kBinsPerOctave * std::log2(block.residuals.depth)))].blocks.push_back(&block);
  std::vector<DepthBin> usable;
  for (auto& [index, bin] : bins) {
    if (bin.blocks.size() < kFewestPerBin) continue;
    std::vector<double> r;
    double log_depth = 0.0;
    for (const auto* block : bin.blocks) {
      r.push_back(block->residuals.r);
      log_depth += std::log(block->residuals.depth);
    }
    bin.weight = static_cast<double>(bin.blocks.size());
    bin.depth = std::exp(log_depth / bin.weight);
    bin.r = quantile(r, kLowQuantile);
    if (bin.r > 0.0) usable.push_back(bin);
  }
  return usable;
}

/// Median over a bin's flat blocks, mean over the bins by their number of blocks.
double correlationAt(const std::vector<DepthBin>& bins, std::size_t lag) {
  double sum = 0.0;
  double weight = 0.0;
  for (const auto& bin : bins) {
    std::vector<double> values;
    for (const auto* block : bin.blocks)
      if (block->residuals.r < kFlatBlock * bin.r) values.push_back(block->residuals.correlation[lag]);
    if (values.empty()) continue;
    sum += bin.weight * quantile(values, 0.5);
    weight += bin.weight;
  }
  return weight > 0.0 ? sum / weight : 0.0;
}

NoiseClass classify(const std::vector<DepthBin>& bins, int block_size) {
  const double rho1 = correlationAt(bins, 0);
  const double rho2 = correlationAt(bins, 1);
  const double rho4 = correlationAt(bins, 2);
  const double rho8 = correlationAt(bins, 3);
  const bool small = block_size < 32;
  if (small ? rho1 < 0.30 : rho1 < 0.45 || rho2 < 0.35) return NoiseClass::White;
  return (small ? rho4 : rho8) > 0.14 ? NoiseClass::Long : NoiseClass::Mid;
}

double correlationLength(NoiseClass noise_class, double longer_side) {
  switch (noise_class) {
    case NoiseClass::White:
      return 1.0;
    case NoiseClass::Mid:
      return std::clamp(longer_side / 160.0, 1.5, 4.0);
    default:
      return std::clamp(longer_side / 70.0, 3.0, 9.0);
  }
}

// Half-size blocks fit between the clutter; where the error is short they see all of it.
void guardAgainstClutter(const InverseDepthImage& image, int size, std::vector<DepthBin>& bins) {
  const int half = size / 2;
  for (auto& bin : bins) {
    std::vector<double> r;
    for (const auto* block : bin.blocks)
      for (const int shift : {0, half})
        if (const auto part = measureBlock(image, block->row + shift, block->column + shift, half))
          r.push_back(part->r);
    if (r.size() >= kFewestPerBin) bin.r = std::min(bin.r, kClutterGuard * quantile(r, kLowQuantile));
  }
}

/// Zero and kGrid - 1 values evenly spaced on a logarithmic scale.
std::vector<double> logGrid(double low, double high) {
  std::vector<double> values = {0.0};
  for (int i = 0; i < kGrid - 1; ++i) values.push_back(low * std::pow(high / low, i / (kGrid - 2.0)));
  return values;
}

// Below the median of the bins: clutter only enlarges them.
void fitSigma(const std::vector<DepthBin>& bins, SensorEstimate& estimate) {
  double best = std::numeric_limits<double>::infinity();
  for (const double a : logGrid(1e-4, 0.03))
    for (const double b : logGrid(1e-4, 0.03)) {
      double loss = 0.0;
      for (const auto& bin : bins) {
        const double sigma = std::hypot(a, b * bin.depth * bin.depth);
        if (!(sigma > 0.0)) loss = std::numeric_limits<double>::infinity();
        const double e = std::log(kSigmaOverResidual * bin.r / sigma);
        loss += std::min(bin.weight, kHeaviestBin) * (e > 0.0 ? kPinball * e : (kPinball - 1.0) * e);
      }
      if (loss >= best) continue;
      best = loss;
      estimate.a = a;
      estimate.b = b;
    }
}

}  // namespace

SensorEstimate estimateSensor(const DepthFrame& frame) {
  SensorEstimate estimate;
  const double longer_side = std::max(frame.width(), frame.height());
  estimate.correlation_length = std::min(6.0, longer_side / 100.0);
  if (frame.empty()) return estimate;
  InverseDepthImage image;
  image.read(frame, SensorModel());

  int size = longer_side < 400 ? 16 : 32;
  auto blocks = measureBlocks(image, size);
  auto bins = binByDepth(blocks);
  if (bins.empty() && size == 32) {
    size = 16;
    blocks = measureBlocks(image, size);
    bins = binByDepth(blocks);
  }
  if (bins.empty()) return estimate;

  for (const auto& bin : bins) estimate.blocks += bin.blocks.size();
  estimate.noise_class = classify(bins, size);
  estimate.correlation_length = correlationLength(estimate.noise_class, longer_side);
  if (estimate.noise_class != NoiseClass::Long) guardAgainstClutter(image, size, bins);
  fitSigma(bins, estimate);
  return estimate;
}

SensorEstimator::SensorEstimator(std::size_t memory) : memory_(std::max<std::size_t>(memory, 1)) {}

void SensorEstimator::reset() {
  estimates_.clear();
  next_ = 0;
}

SensorEstimate SensorEstimator::update(const DepthFrame& frame) {
  if (frame.width() != width_ || frame.height() != height_) reset();
  width_ = frame.width();
  height_ = frame.height();
  const SensorEstimate latest = estimateSensor(frame);
  if (latest.blocks > 0) {
    if (estimates_.size() < memory_)
      estimates_.push_back(latest);
    else
      estimates_[next_++ % memory_] = latest;
  }
  if (estimates_.empty()) return latest;

  std::array<int, 3> votes{};
  std::vector<double> a, b;
  SensorEstimate stream = latest;
  stream.blocks = 0;
  for (const auto& estimate : estimates_) {
    ++votes[static_cast<std::size_t>(estimate.noise_class)];
    a.push_back(estimate.a);
    b.push_back(estimate.b);
    stream.blocks += estimate.blocks;
  }
  stream.noise_class = static_cast<NoiseClass>(std::max_element(votes.begin(), votes.end()) - votes.begin());
  stream.correlation_length = correlationLength(stream.noise_class, std::max(width_, height_));
  stream.a = quantile(a, 0.5);
  stream.b = quantile(b, 0.5);
  return stream;
}

}  // namespace epcc
