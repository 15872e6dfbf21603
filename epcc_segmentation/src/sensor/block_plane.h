// SPDX-License-Identifier: BSD-3-Clause
// Robust plane of one image block, in its true rays.
#pragma once

#include "inverse_depth/inverse_depth_image.h"
#include "sensor/block_kernels.h"

namespace epcc {

/// A square part of an image.
struct BlockPlace {
  int row, column;
  int side;
};

/// A block and its plane.
struct FittedBlock {
  BlockSamples samples;  ///< without their centre
  BlockRays rays;
  SamplePlane plane;
  double w = 0.0;         ///< of the plane, in the middle
  float gate = 0.0f;      ///< for the residuals of the plane's inliers
  double depth = 0.0;     ///< measured depth, metres
  double to_depth = 0.0;  ///< from an inverse depth's difference to the measured depth's
  double tan2 = 0.0;      ///< tan^2 of the angle between ray and normal, clipped
  double step = 0.0;      ///< smallest difference of two inverse depths
};

/// False if less than 80 % of the block is valid or it has no plane. `full_share` is what is valid of a block where the
/// scene has no holes (ImageBlocks::fullShare()): the 80 % are of that.
bool fitBlock(const InverseDepthImage& image, const BlockPlace& place, FittedBlock& block, double full_share = 1.0);

}  // namespace epcc
