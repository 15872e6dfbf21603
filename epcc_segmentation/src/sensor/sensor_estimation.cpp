// SPDX-License-Identifier: BSD-3-Clause
// Blocks -> depth bins -> blotches -> sigma_z(z).
#include "epcc_segmentation/sensor_estimation.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/sensor_cloud.h"
#include "inverse_depth/scattered_pixels.h"
#include "sensor/block_parts.h"
#include "sensor/image_estimation.h"
#include "sensor/model_length.h"

namespace epcc {

namespace {

constexpr int kLargeBlock = 32;
constexpr int kSmallBlock = 16;
constexpr int kSmallHeight = 200, kSmallWidth = 400;  // shorter and longer side, pixels
constexpr int kRounds = 3;

// An effective length of 0.4 is that of grain alone.
// Sigma of the model over that of the error, if it is blotches: their residuals scatter from block to block.
constexpr double kSigmaOverBlotches = 2.4;
// Of a bending three quarters of a block long: what the terms of second order of a block's quadric hold.
constexpr double kBentShare = 0.03;
constexpr double kPlaceOfBlotch = 1.2;
constexpr double kMaxBinWeight = 20.0;

// Of the length that the model is given: the image must hold about 69 faces of minimal evidence.
constexpr double kLeastLength = 1.5;  // pixels of an image of 640 x 480
constexpr double kFacesOfImage = 69.0;
// A scanner measures each pixel by itself. Where its residuals agree farther than that, it is the offset of a ring, or
// the scene: streets and facades are never flat.
constexpr double kLengthOfScans = 1.0;

double largestLength(double width, double height) {
  return std::sqrt(width * height) / kFacesOfImage;
}

double lengthOfModel(double effective_length, const InverseDepthImage& image) {
  if (!image.planar_rows) return kLengthOfScans;
  const double width = image.width, height = image.height;
  const double least = kLeastLength * std::sqrt(width * height / (640.0 * 480.0));
  const double length = std::max(least, lengthOfError(effective_length));
  return std::min(length, largestLength(width, height));
}

/// Of the model's variance, in which whole surfaces err together: all of it unless grain outweighs blotches and
/// bending. SlowBending tells the bending better, but from regions, which there are none of yet.
double correlatedShare(double blotches, double bent_over_chance, int side) {
  const double of_terms = std::max(0.0, bent_over_chance - 1.0) * (kTerms - kPlaneTerms) / (side * side);
  const double common = blotches * kSigmaOverBlotches * kSigmaOverBlotches + of_terms / kBentShare;
  return std::min(1.0, common / std::max(1.0 - blotches, 1e-9));
}

/// Where nothing was measured.
SensorEstimate genericEstimate(const InverseDepthImage& image) {
  SensorEstimate estimate;
  estimate.correlation_length =
      image.planar_rows ? std::min(6.0, largestLength(image.width, image.height)) : kLengthOfScans;
  return estimate;
}

}  // namespace

SensorEstimate estimateSensor(const DepthFrame& frame) {
  InverseDepthImage image;
  SensorCloud cloud;
  if (!frame.empty()) image.read(inSensorFrame(frame, cloud));
  ScatteredPixels scattered;
  return ImageEstimation().whole(scattered.measuredForm(image));
}

ImageEstimation::ImageEstimation() : fitter_(kMaxBlocks) {
  targets_.reserve(kMaxBlocks);
  blotchTable(kLargeBlock);  // so that no later frame has to build it
}

int ImageEstimation::blockSize(int width, int height) {
  const auto [shorter, longer] = std::minmax(width, height);
  return shorter < kSmallHeight || longer < kSmallWidth ? kSmallBlock : kLargeBlock;
}

int ImageEstimation::otherSize(int block_size) {
  return block_size == kLargeBlock ? kSmallBlock : kLargeBlock;
}

void ImageEstimation::begin(int block_size) {
  blocks_.begin(block_size);
  halves_.begin(block_size / 2);
}

void ImageEstimation::measure(const InverseDepthImage& image, const Turn& turn) {
  blocks_.measure(image, turn);
  if (blocks_.blockSize() == kLargeBlock) halves_.measure(image, turn);
}

SensorEstimate ImageEstimation::share(const InverseDepthImage& image, const Turn& turn) {
  if (image.width <= 0 || image.height <= 0) return genericEstimate(image);
  const int first = blockSize(image.width, image.height);
  SensorEstimate result;
  for (const int size : {first, otherSize(first)}) {
    begin(size);
    measure(image, turn);
    result = estimate(image);
    if (result.blocks > 0) break;
  }
  return result;
}

SensorEstimate ImageEstimation::estimate(const InverseDepthImage& image) {
  SensorEstimate result = genericEstimate(image);
  bins_.sort(blocks_.flat());
  if (bins_.empty()) return result;
  const BlotchTable& table = blotchTable(blocks_.blockSize());
  SigmaShape sigma;
  double blotchy = 1.0;
  for (int round = 0; round < kRounds; ++round) {
    bins_.findDeviations(sigma, 1.0 - blotchy);
    kept_ = bins_.kept(sigma, 1.0 - blotchy);
    blotches_ = table.fit(kept_);
    const double effective_length = blotches_.effectiveLength();
    blotchy = blotches_.share;
    // Grain is an error along the ray, blotches are one across the surface.
    bins_.findDeviations(sigma, 1.0 - blotchy);
    if (blocks_.blockSize() == kLargeBlock) bins_.guardAgainstClutter(halves_.flat(), 1.0 - blotchy, kept_.back());
    result.blotch_length = blotches_.length;
    result.blotch_share = blotches_.share;
    result.effective_length = effective_length;
    result.correlation_length = lengthOfModel(effective_length, image);
    findTargets(blotchy,
                kPlaceOfBlotch * std::sqrt(blotchy) * result.correlation_length * std::sqrt(image.placeVariance()));
    if (targets_.empty()) return genericEstimate(image);
    const SigmaFit fit = fitter_.fit(targets_);
    result.a = fit.a;
    result.b = fit.b;
    sigma = {fit.a, fit.b, true};
  }
  if (!result.model().validate().empty()) return genericEstimate(image);  // of numbers that no sensor measured
  result.correlated_share = correlatedShare(blotches_.share, bins_.bentOverChance(), blocks_.blockSize());
  const double pixels = image.steps.side();
  for (double* length : {&result.correlation_length, &result.blotch_length, &result.effective_length})
    *length *= pixels;
  result.blocks = bins_.blockCount();
  return result;
}

SensorMeasurement ImageEstimation::describe(const InverseDepthImage& image) {
  SensorMeasurement result;
  result.estimate = estimate(image);
  if (result.estimate.blocks == 0) return result;
  for (const BlockResiduals& block : blocks_.flat()) result.blocks.push_back({block.depth, block.deviation});
  for (std::size_t i = 0, target = 0; i < bins_.size(); ++i) {
    const DepthBin& bin = bins_[i];
    const bool has_target = target < targets_.size() && targets_[target].depth == bin.depth;
    const double sigma = has_target ? std::exp(targets_[target++].log_sigma) : 0.0;
    result.bins.push_back({bin.depth, bin.deviation * std::sqrt(blotches_.variance), sigma, bin.end - bin.begin});
  }
  const double blotches = blotches_.fitted * blotches_.variance;
  result.grain = blotches_.variance - blotches;
  result.blotches = blotches;
  for (std::size_t scale = 0; scale < kScales; ++scale) {
    const int side = blocks_.blockSize() >> (kScales - 1 - scale);
    result.sides[scale] = side;
    result.kept[scale] = scale + 1 < kScales ? kept_[scale] : 1.0;
    result.kept_fit[scale] =
        result.grain * keptByQuadric(0.0, side) + result.blotches * keptByQuadric(blotches_.length, side);
  }
  return result;
}

/// What the model is to say at each bin. Three errors: what is seen; at least the rounding of the depth, up to half a
/// step, which flat blocks may hide; and the place of a value, which is known to a blotch on surfaces of any slope.
void ImageEstimation::findTargets(double blotchy, double place) {
  targets_.clear();
  const double over_residual =
      std::sqrt((1.0 - blotchy + blotchy * kSigmaOverBlotches * kSigmaOverBlotches) * blotches_.variance);
  for (std::size_t i = 0; i < bins_.size(); ++i) {
    const DepthBin& bin = bins_[i];
    const double seen = std::max(over_residual * bin.deviation, 0.5 * bin.step);
    const double sigma = std::hypot(seen, place * bin.depth);
    if (sigma > 0.0) targets_.push_back({bin.depth, std::log(sigma), std::min(bin.weight(), kMaxBinWeight)});
  }
}

}  // namespace epcc
