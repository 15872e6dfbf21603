// SPDX-License-Identifier: BSD-3-Clause
// How a region bends: the quadric that fits better than its plane.
#pragma once

#include <vector>

#include "inverse_depth/region_map.h"

namespace epcc {

/// What a quadratic surface w(u, v) explains of a region's residuals from its plane; squares in sigma^2 across the
/// surface.
struct Bending {
  double curvature = 0.0;  ///< largest principal curvature, absolute, 1/m
  double gain = 0.0;       ///< residual sum of squares that the quadratic terms take away
  double rss = 0.0;        ///< residual sum of squares of the plane
};

/// Measures the regions k with wanted[k] != 0; the others stay zero. One pass over the pixels.
std::vector<Bending> measureBending(const InverseDepthImage& image, const RegionMap& map,
                                    const std::vector<std::uint8_t>& wanted);

}  // namespace epcc
