// SPDX-License-Identifier: BSD-3-Clause
// The cross product of vectors in a plane.
#pragma once

#include <Eigen/Core>

namespace epcc {

/// Twice the area of the triangle (0, a, b), negative if it runs clockwise.
inline double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

}  // namespace epcc
