// SPDX-License-Identifier: BSD-3-Clause
// The sensor measured on a frame that has been read, so that nobody reads it twice: blocks -> depth bins -> blotches ->
// sigma_z(z).
#pragma once

#include <array>
#include <vector>

#include "epcc_segmentation/sensor_estimation.h"
#include "inverse_depth/inverse_depth_image.h"
#include "sensor/blotch_fit.h"
#include "sensor/depth_bins.h"
#include "sensor/image_blocks.h"
#include "sensor/sigma_fit.h"

namespace epcc {

/// Measures whole images, or blocks of several in turn; keeps its memory.
class ImageEstimation {
 public:
  ImageEstimation();
  /// As estimateSensor(const DepthFrame&); the image need not be weighed.
  SensorEstimate whole(const InverseDepthImage& image) { return share(image, Turn()); }
  /// The same from a share of its blocks.
  SensorEstimate share(const InverseDepthImage& image, const Turn& turn);

  /// Begins anew, with blocks of this size.
  void begin(int block_size);
  /// A share of the blocks.
  void measure(const InverseDepthImage& image, const Turn& turn);
  /// Of what was measured since begin(), on images of this geometry.
  SensorEstimate estimate(const InverseDepthImage& image);
  /// The same, and what it comes from but for the autocorrelation.
  SensorMeasurement describe(const InverseDepthImage& image);
  /// Blocks of both sizes looked at since begin(), flat or not.
  std::size_t lookedAt() const { return blocks_.lookedAt() + halves_.lookedAt(); }

  /// The flat blocks that were measured since begin().
  const std::vector<BlockResiduals>& flatBlocks() const { return blocks_.flat(); }

  /// Side of the blocks that an image of this size is measured with first.
  static int blockSize(int width, int height);
  /// Of those that are used where the first ones find nothing.
  static int otherSize(int block_size);

 private:
  void findTargets(double blotchy, double place);

  ImageBlocks blocks_;
  ImageBlocks halves_;  // of half the size, spread over the image by themselves
  DepthBins bins_;
  std::vector<SigmaTarget> targets_;
  SigmaFitter fitter_;
  // of the last round
  Blotches blotches_;
  std::array<double, kScales - 1> kept_{};
};

}  // namespace epcc
