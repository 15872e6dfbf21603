// SPDX-License-Identifier: BSD-3-Clause
// What one image block tells of the sensor's error.
#pragma once

#include <array>
#include <cmath>
#include <optional>

#include "sensor/block_plane.h"
#include "sensor/block_quadrics.h"

namespace epcc {

struct BlockResiduals {
  double depth = 0.0;      ///< measured depth at the block, metres
  double deviation = 0.0;  ///< rms residual of a quadric, across the surface, metres
  double slant = 1.0;      ///< square of the axial residual over that across the surface: 1 + tan^2
  double step = 0.0;       ///< smallest difference of two depths, metres: the step of a quantised depth
  BlockPlace place = {0, 0, 0};
  /// Inverse depth of its plane in the middle, and how far it changes from there to the block's right and lower side.
  double w = 0.0, w_right = 0.0, w_down = 0.0;
  /// Mean squares that separate quadrics in the block's parts, of a quarter and of half its side, leave of those that
  /// one quadric leaves.
  std::array<double, kScales - 1> kept{};
  double bent = 1.0;  ///< see QuadricResiduals

  /// The residual along the ray (axial = 1) or across the surface (0), or between.
  double deviationAlong(double axial) const { return deviation * std::pow(slant, 0.5 * axial); }
};

/// Nothing if less than 80 % of what may be valid of the block (fitBlock()) is valid, or less than 75 % of that lies on
/// one plane.
std::optional<BlockResiduals> measureBlock(const InverseDepthImage& image, const BlockPlace& place,
                                           double full_share = 1.0);

}  // namespace epcc
