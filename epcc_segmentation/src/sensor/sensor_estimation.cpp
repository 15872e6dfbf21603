// SPDX-License-Identifier: BSD-3-Clause
// Blocks -> depth bins -> blotches -> sigma_z(z).
#include "epcc_segmentation/sensor_estimation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "sensor/depth_bins.h"
#include "sensor/fitted_blotches.h"
#include "sensor/image_estimation.h"

namespace epcc {

namespace {

// Sigma of the model over a low quantile of the error. A block's residuals tell white noise to a few percent, those of
// blotches scatter from block to block; noise counts as blotches from this correlation with the next pixel on.
constexpr double kSigmaOverWhite = 1.7;
constexpr double kSigmaOverBlotches = 2.6;
constexpr double kBlotchCorrelation = 0.3;
// Blocks that tell the correlation, in deviations of their bin. Blotches as long as a block leave some blocks flat and
// uncorrelated by chance, so that all but the clutter must speak; short ones leave all alike, and the flattest have the
// least clutter.
constexpr double kFlatBlock = 1.5;
constexpr double kFlattestBlock = 1.2;
constexpr double kLongCorrelation = 0.14;  // at a quarter of the block: half-size blocks would hardly see the error
constexpr double kLengthOverFit = 1.2;     // a block shows a length of 8 px as 6.7
constexpr double kMaxLengthOfImage = 1.0 / 67;
constexpr double kMinBlotch = 1.5;
constexpr double kPinball = 0.3;
constexpr double kMaxBinWeight = 20.0;
constexpr int kGrid = 33;

/// Standard deviation of an even distribution over an interval of this width.
double evenDeviation(double width) {
  return width / std::sqrt(12.0);
}

bool isWhite(const std::array<double, kLags.size()>& correlation, int block_size) {
  return block_size < 32 ? correlation[0] < 0.30 : correlation[0] < 0.45 || correlation[1] < 0.35;
}

double sigmaOverError(double next_pixel_correlation) {
  const double share = std::clamp(next_pixel_correlation / kBlotchCorrelation, 0.0, 1.0);
  return kSigmaOverWhite + share * (kSigmaOverBlotches - kSigmaOverWhite);
}

/// What the model is to say at the bin. Three errors: what is seen; at least the quantisation of the depth, which flat
/// blocks may hide and whose terraces are blotches; and the place of a value, which is known to a blotch, or a pixel,
/// on surfaces of any slope.
double targetSigma(const DepthBin& bin, double sigma_over_residual, double place) {
  const double seen = std::max(sigma_over_residual * bin.deviation, kSigmaOverBlotches * evenDeviation(bin.step));
  return std::hypot(seen, place * bin.depth);
}

/// Zero and kGrid - 1 values evenly spaced on a logarithmic scale.
std::vector<double> logGrid(double low, double high) {
  std::vector<double> values = {0.0};
  for (int i = 0; i < kGrid - 1; ++i) values.push_back(low * std::pow(high / low, i / (kGrid - 2.0)));
  return values;
}

// Below the median of the bins: clutter only enlarges them.
void fitSigma(const std::vector<DepthBin>& bins, const std::vector<double>& log_targets, SensorEstimate& estimate) {
  const auto grid = logGrid(1e-4, 0.03);
  double best = std::numeric_limits<double>::infinity();
  for (const double a : grid)
    for (const double b : grid) {
      if (a + b <= 0.0) continue;
      double loss = 0.0;
      for (std::size_t i = 0; i < bins.size(); ++i) {
        const double z2 = bins[i].depth * bins[i].depth;
        const double e = log_targets[i] - 0.5 * std::log(a * a + b * b * z2 * z2);
        loss += std::min(bins[i].weight, kMaxBinWeight) * (e > 0.0 ? kPinball * e : (kPinball - 1.0) * e);
      }
      if (loss >= best) continue;
      best = loss;
      estimate.a = a;
      estimate.b = b;
    }
}

}  // namespace

SensorEstimate estimateSensor(const DepthFrame& frame) {
  InverseDepthImage image;
  if (!frame.empty()) image.read(frame);
  return estimateSensor(image);
}

SensorEstimate estimateSensor(const InverseDepthImage& image) {
  SensorEstimate estimate;
  const double longer_side = std::max(image.width, image.height);
  estimate.correlation_length = std::min(6.0, longer_side / 100.0);
  if (image.width <= 0 || image.height <= 0) return estimate;

  int size = longer_side < 400 ? 16 : 32;
  auto bins = measureDepthBins(image, size);
  if (bins.empty() && size == 32) {
    size = 16;
    bins = measureDepthBins(image, size);
  }
  if (bins.empty()) return estimate;
  for (const auto& bin : bins) estimate.blocks += bin.blocks.size();

  const auto correlation = correlationOf(bins, kFlatBlock);
  Blotches blotches;
  blotches.block_size = size;
  estimate.noise_class = NoiseClass::White;
  estimate.correlation_length = 1.0;
  if (!isWhite(correlation, size)) {
    const bool is_long = correlation[size < 32 ? 2 : 3] > kLongCorrelation;
    estimate.noise_class = is_long ? NoiseClass::Long : NoiseClass::Mid;
    blotches = fitBlotches(is_long ? correlation : correlationOf(bins, kFlattestBlock), size);
    estimate.correlation_length =
        std::max(kMinBlotch, std::min(kLengthOverFit * blotches.length, kMaxLengthOfImage * longer_side));
  }
  if (estimate.noise_class != NoiseClass::Long) guardAgainstClutter(image, size, bins);
  const double sigma_over_residual = sigmaOverError(correlation[0]) * blotches.errorOverResidual();
  const double place = blotches.length * std::sqrt(image.placeVariance());
  std::vector<double> log_targets;
  for (const auto& bin : bins) log_targets.push_back(std::log(targetSigma(bin, sigma_over_residual, place)));
  fitSigma(bins, log_targets, estimate);
  return estimate;
}

}  // namespace epcc
