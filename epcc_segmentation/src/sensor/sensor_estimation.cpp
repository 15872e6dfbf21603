// SPDX-License-Identifier: BSD-3-Clause
// Blocks -> depth bins -> blotches -> sigma_z(z).
#include "epcc_segmentation/sensor_estimation.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/sensor_cloud.h"
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
constexpr double kMaxBinWeight = 20.0;
constexpr int kLargeBlock = 32;
constexpr int kSmallImage = 400;  // longer side, pixels

/// Standard deviation of an even distribution over an interval of this width.
double evenDeviation(double width) {
  return width / std::sqrt(12.0);
}

bool isWhite(const std::array<double, kLags.size()>& correlation, int block_size) {
  return block_size < kLargeBlock ? correlation[0] < 0.30 : correlation[0] < 0.45 || correlation[1] < 0.35;
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

/// Where nothing was measured.
SensorEstimate genericEstimate(double longer_side) {
  SensorEstimate estimate;
  estimate.correlation_length = std::min(6.0, longer_side / 100.0);
  return estimate;
}

}  // namespace

SensorEstimate estimateSensor(const DepthFrame& frame) {
  InverseDepthImage image;
  SensorCloud cloud;
  if (!frame.empty()) image.read(frame.geometry() == nullptr ? frame : cloud.of(frame, 1));
  return ImageEstimation().whole(image);
}

ImageEstimation::ImageEstimation() {
  targets_.reserve(kMaxBlocks);
  blotchTable(kLargeBlock);  // so that no later frame has to build it
}

int ImageEstimation::blockSize(int width, int height) {
  return std::max(width, height) < kSmallImage ? kSmallBlock : kLargeBlock;
}

SensorEstimate ImageEstimation::whole(const InverseDepthImage& image) {
  if (image.width <= 0 || image.height <= 0) return genericEstimate(0.0);
  begin(blockSize(image.width, image.height));
  blocks_.measure(image, Turn());
  const SensorEstimate result = estimate(image, true);
  if (result.blocks > 0 || blocks_.blockSize() == kSmallBlock) return result;
  begin(kSmallBlock);
  blocks_.measure(image, Turn());
  return estimate(image, true);
}

void ImageEstimation::measure(const InverseDepthImage& image, const Turn& turn, bool with_halves) {
  blocks_.measure(image, turn);
  if (with_halves)
    blocks_.measureHalves(image);
  else
    blocks_.leaveOutHalves();
}

SensorEstimate ImageEstimation::estimate(const InverseDepthImage& image, bool halves_are_missing) {
  const double longer_side = std::max(image.width, image.height);
  const int size = blocks_.blockSize();
  SensorEstimate result = genericEstimate(longer_side);
  bins_.sort(blocks_.flat());
  if (bins_.empty()) return result;
  result.blocks = bins_.blockCount();

  const auto correlation = bins_.correlation(kFlatBlock);
  Blotches blotches;
  result.noise_class = NoiseClass::White;
  result.correlation_length = 1.0;
  if (!isWhite(correlation, size)) {
    const bool is_long = correlation[size < kLargeBlock ? 2 : 3] > kLongCorrelation;
    result.noise_class = is_long ? NoiseClass::Long : NoiseClass::Mid;
    blotches = blotchTable(size).fit(is_long ? correlation : bins_.correlation(kFlattestBlock));
    result.correlation_length =
        std::max(kMinBlotch, std::min(kLengthOverFit * blotches.length, kMaxLengthOfImage * longer_side));
  }
  if (result.noise_class != NoiseClass::Long) {
    if (halves_are_missing) blocks_.measureHalves(image);
    bins_.guardAgainstClutter();
  }
  findTargets(sigmaOverError(correlation[0]) * blotches.errorOverResidual(),
              blotches.length * std::sqrt(image.placeVariance()));
  const SigmaFit fit = fitSigma(targets_);
  if (fit.a + fit.b > 0.0) {
    result.a = fit.a;
    result.b = fit.b;
  }
  return result;
}

void ImageEstimation::findTargets(double sigma_over_residual, double place) {
  targets_.clear();
  for (std::size_t i = 0; i < bins_.size(); ++i)
    targets_.push_back({bins_[i].depth, std::log(targetSigma(bins_[i], sigma_over_residual, place)),
                        std::min(bins_[i].weight, kMaxBinWeight)});
}

}  // namespace epcc
