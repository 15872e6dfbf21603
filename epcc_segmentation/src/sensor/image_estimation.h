// SPDX-License-Identifier: BSD-3-Clause
// The sensor measured on a frame that has been read, so that nobody reads it twice: blocks -> depth bins -> blotches ->
// sigma_z(z).
#pragma once

#include <vector>

#include "epcc_segmentation/sensor_estimation.h"
#include "inverse_depth/inverse_depth_image.h"
#include "sensor/depth_bins.h"
#include "sensor/image_blocks.h"
#include "sensor/sigma_fit.h"

namespace epcc {

/// Measures whole images, or blocks of several in turn; keeps its memory.
class ImageEstimation {
 public:
  ImageEstimation();
  /// As estimateSensor(const DepthFrame&); the image need not be weighed.
  SensorEstimate whole(const InverseDepthImage& image);

  /// Begins anew, with blocks of this size.
  void begin(int block_size) { blocks_.begin(block_size); }
  /// A share of the blocks. Those of half the size only tell of errors that are short against them.
  void measure(const InverseDepthImage& image, const Turn& turn, bool with_halves);
  /// Of what was measured since begin(), on images of this geometry.
  SensorEstimate estimate(const InverseDepthImage& image) { return estimate(image, false); }
  /// Blocks looked at since begin(), flat or not.
  std::size_t lookedAt() const { return blocks_.lookedAt(); }

  /// Side of the blocks that an image of this size is measured with first.
  static int blockSize(int width, int height);
  /// Used where the larger ones find nothing.
  static constexpr int kSmallBlock = 16;

 private:
  SensorEstimate estimate(const InverseDepthImage& image, bool halves_are_missing);
  void findTargets(double sigma_over_residual, double place);

  ImageBlocks blocks_;
  DepthBins bins_;
  std::vector<SigmaTarget> targets_;
};

}  // namespace epcc
