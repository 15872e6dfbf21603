// SPDX-License-Identifier: BSD-3-Clause
// A line segment of one scan line with its prototype, what Algorithm 1 hands to Algorithm 2.
#pragma once

#include <Eigen/Core>

#include "metric/recursive_statistics.h"

namespace epcc {

/// Linear prototype: recursive statistics, residual variance (Eq. 11) and unit normal.
struct LinePrototype {
  RecursiveStatistics<2> statistics;
  double variance = 0.0;
  Eigen::Vector2d normal = Eigen::Vector2d::UnitX();

  /// Signed orthogonal distance (Eq. 19 without its absolute value).
  double distance(const Eigen::Vector2d& t) const { return (t - statistics.mean).dot(normal); }
  /// Foot of the perpendicular from a point (Eq. 21).
  Eigen::Vector2d project(const Eigen::Vector2d& t) const { return t - distance(t) * normal; }
  /// Residual variance := smallest eigenvalue of the covariance.
  void resetVariance() { variance = varianceAlong(statistics.covariance, normal); }
};

/// A line segment of one scan line.
struct ClusteredLine {
  int first = 0;  ///< pixel position of the first member along the scan line
  int last = 0;   ///< pixel position of the last member
  LinePrototype prototype;
  /// First and last member projected on the prototype (Eq. 21, signed), in the scan frame, metres.
  Eigen::Vector3d a = Eigen::Vector3d::Zero();
  Eigen::Vector3d b = Eigen::Vector3d::Zero();
};

}  // namespace epcc
