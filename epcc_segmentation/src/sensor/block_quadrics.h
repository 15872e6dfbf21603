// SPDX-License-Identifier: BSD-3-Clause
// What separate quadrics leave of the residuals of a block's plane, in parts of several sizes; for any vector unit with
// the same bits.
#pragma once

#include <array>

#include "sensor/block_kernels.h"

namespace epcc {

/// Parts of a quarter and of half of the block's side, and the block itself.
constexpr int kScales = 3;

struct QuadricResiduals {
  double inliers = 0.0;  ///< of the plane, |e| <= gate
  /// Mean squares after a quadric (1, x, y, x^2, xy, y^2) over the inliers of each part, pooled over the parts of which
  /// at least 60 % of what may be valid, and 12 pixels, are inliers; 0 where there is no such part.
  std::array<double, kScales> squares{};
  /// Variance along each of the block's three terms of second order, over that of its pixels after the quadric: 1 of
  /// white error on a plane, more of all that bends.
  double bent = 1.0;
};

/// The side must be four times a multiple of four. The sums over a part come from those over its quarters.
QuadricResiduals fitQuadrics(const BlockSamples& samples, const BlockRays& rays, const SamplePlane& plane, float gate,
                             double full_share = 1.0);

}  // namespace epcc
