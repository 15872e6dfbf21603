// SPDX-License-Identifier: BSD-3-Clause
// The projections that the algorithm works in.
#pragma once

namespace epcc {

/// How the pixels of an organized measurement see the world.
enum class Projection {
  Perspective,          ///< measured value z along the optical axis; columns and rows are planar sections
  PerspectiveBackward,  ///< the same seen along -z with y up, as in computer graphics: valid points have z < 0
  Spherical  ///< measured value range; columns (fixed azimuth about the z-up axis) are planar sections, rows are cones
};

/// True if the measured value is a distance along the optical axis.
inline bool isPerspective(Projection projection) {
  return projection != Projection::Spherical;
}

}  // namespace epcc
