// SPDX-License-Identifier: BSD-3-Clause
// Differences of planes -> squares of offset and slope -> share and length of the bending.
#include "sensor/slow_bending.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "quantile.h"

namespace epcc {

namespace {

constexpr std::size_t kMemory = 600;    // blocks: of four frames at least
constexpr std::size_t kFewestBent = 8;  // that say anything
constexpr double kLargestShare = 0.5;   // of a block's offset that its region's plane may have taken up
constexpr double kOneSigma = 0.6827;
constexpr double kQuantileError = 1.92;  // standard deviation of that quantile of n squares: its own size over sqrt(n)
// Lengths looked at, in sides of a block: of faster waves its quadric leaves enough, of slower ones it sees a plane.
constexpr double kShortest = 0.25, kLongest = 3.0;
constexpr double kBeyondBlotches = 1.5;  // times their length
constexpr double kBendingLengthStep = 1.1;

/// Variance of a block's offset, and of its slope over half of its side, of an error of variance 1.
struct BlockVariances {
  double offset, slope;
};

BlockVariances variancesOf(const ErrorCorrelation& error, int side) {
  const SamplesPerIndependent worth = samplesPerIndependent(error, side, side, 1);
  const double pixels = static_cast<double>(side) * side;
  return {worth.offset / pixels, 3.0 * worth.long_slope / pixels};
}

/// The label that a block's middle and its corners have, 0 if they do not agree.
std::int32_t labelOf(const BlockPlace& place, const InverseDepthImage& image, const std::vector<std::int32_t>& labels) {
  const int last = place.side - 1;
  const std::int32_t label = labels[image.index(place.row + last / 2, place.column + last / 2)];
  for (const int row : {place.row, place.row + last})
    for (const int column : {place.column, place.column + last})
      if (labels[image.index(row, column)] != label) return 0;
  return label;
}

}  // namespace

SlowBending::SlowBending() {
  seen_.reserve(kMemory);
  offsets_.reserve(kMemory);
  slopes_.reserve(2 * kMemory);
}

void SlowBending::reset() {
  seen_.clear();
  next_ = 0;
}

bool SlowBending::canMeasure(const DepthFrame& frame, const InverseDepthImage& image, const FitSamples& samples) {
  return samples.along_rays && image.planar_rows && !frame.isTransposed() && image.width == frame.width() &&
         image.height == frame.height();
}

// What a region's plane has taken up of a block's offset depends on the bending itself: the first frame is looked at
// twice.
ErrorCorrelation SlowBending::update(const std::pair<const BlockResiduals*, std::size_t>& blocks,
                                     const InverseDepthImage& image, const ErrorCorrelation& measured,
                                     const FittedRegions& regions) {
  if (image.width != width_ || image.height != height_) {
    reset();
    width_ = image.width;
    height_ = image.height;
  }
  ErrorCorrelation error = explain(measured);
  if (seen_.empty()) {
    addBlocks(blocks, image, error, regions);
    error = explain(measured);
    reset();
  }
  addBlocks(blocks, image, error, regions);
  return explain(measured);
}

void SlowBending::addBlocks(const std::pair<const BlockResiduals*, std::size_t>& blocks, const InverseDepthImage& image,
                            const ErrorCorrelation& error, const FittedRegions& regions) {
  if (blocks.second > 0 && blocks.first->place.side != side_) {
    reset();
    side_ = blocks.first->place.side;
  }
  for (std::size_t i = 0; i < blocks.second; ++i) addBlock(blocks.first[i], image, error, regions);
}

void SlowBending::addBlock(const BlockResiduals& block, const InverseDepthImage& image, const ErrorCorrelation& error,
                           const FittedRegions& regions) {
  const std::int32_t label = labelOf(block.place, image, regions.labels);
  if (label <= 0) return;
  const RayFit& fit = regions.fitter.rayFit(static_cast<std::size_t>(label) - 1);
  if (!fit.exists) return;
  const SamplesPerIndependent worth = fit.worth(error);
  const double taken = worth.offset / fit.count / variancesOf(error, side_).offset;
  if (!(taken < kLargestShare)) return;

  const auto row = static_cast<std::size_t>(block.place.row), column = static_cast<std::size_t>(block.place.column);
  const auto last = static_cast<std::size_t>(side_) - 1;
  const Plane& region = regions.planes[static_cast<std::size_t>(label) - 1];
  const Eigen::Vector3d theta = -region.coefficients.head<3>() / region.coefficients(3);
  const double middle_y = 0.5 * (image.along[row] + image.along[row + last]);
  const double half_x = 0.5 * (image.across[column + last] - image.across[column]);
  const double half_y = 0.5 * (image.along[row + last] - image.along[row]);
  const double w = theta.dot(Eigen::Vector3d(image.across[column + (last + 1) / 2], middle_y, 1.0));
  const double variance = fit.unit(worth) * regions.sensor.varianceZ(1.0 / w) * (w * w) * (w * w);
  const Seen seen = {(block.w - w) * (block.w - w) / variance / (1.0 - taken),
                     std::pow(block.w_right - theta(0) * half_x, 2) / variance,
                     std::pow(block.w_down - theta(1) * half_y, 2) / variance};
  if (!std::isfinite(seen.offset + seen.right + seen.down)) return;
  if (seen_.size() < kMemory)
    seen_.push_back(seen);
  else
    seen_[next_++ % kMemory] = seen;
}

// With a bending of b times the variance of all else, (1 + b) times what is seen is what blotches and grain give and b
// times what bending of that length gives, of offsets as of slopes.
ErrorCorrelation SlowBending::explain(const ErrorCorrelation& measured) {
  if (seen_.size() < kFewestBent) return measured;
  offsets_.clear();
  slopes_.clear();
  for (const Seen& seen : seen_) {
    offsets_.push_back(seen.offset);
    slopes_.push_back(seen.right);
    slopes_.push_back(seen.down);
  }
  const double offset = quantile(offsets_, kOneSigma), slope = quantile(slopes_, kOneSigma);
  const BlockVariances own = variancesOf(measured, side_);
  const double by_chance = kQuantileError / std::sqrt(static_cast<double>(offsets_.size()));
  if (!(offset > own.offset * (1.0 + by_chance))) return measured;
  double least = std::numeric_limits<double>::infinity();
  ErrorCorrelation best = measured;
  for (double length = std::max(kBeyondBlotches * measured.blotches.length, kShortest * side_);
       length <= kLongest * side_; length *= kBendingLengthStep) {
    const BlockVariances of_bending = variancesOf({{1.0, length}, {}}, side_);
    if (!(of_bending.offset > offset)) continue;
    const double bending = (offset - own.offset) / (of_bending.offset - offset);
    const double expected = (own.slope + bending * of_bending.slope) / (1.0 + bending);
    const double loss = std::abs(std::log(expected / slope));
    if (!(loss < least)) continue;
    least = loss;
    best.blotches.share = measured.blotches.share / (1.0 + bending);
    best.bending = {bending / (1.0 + bending), length};
  }
  return best;
}

}  // namespace epcc
