// SPDX-License-Identifier: BSD-3-Clause
// Smallest distance between two line segments in space, d_ev of Eq. 27.
#pragma once

#include <Eigen/Core>
#include <algorithm>

namespace epcc {

/// Squared distance between the segments a1-b1 and a2-b2; either may be a point.
inline double squaredSegmentDistance(const Eigen::Vector3d& a1, const Eigen::Vector3d& b1, const Eigen::Vector3d& a2,
                                     const Eigen::Vector3d& b2) {
  const auto unit = [](double value) { return std::clamp(value, 0.0, 1.0); };
  const Eigen::Vector3d d1 = b1 - a1;
  const Eigen::Vector3d d2 = b2 - a2;
  const Eigen::Vector3d r = a1 - a2;
  const double a = d1.squaredNorm();
  const double e = d2.squaredNorm();
  const double c = d1.dot(r);
  const double f = d2.dot(r);
  double s = 0.0;  // parameter of the closest point on the first segment
  double t = 0.0;  // and on the second
  if (a > 0.0 && e > 0.0) {
    const double b = d1.dot(d2);
    const double determinant = a * e - b * b;
    if (determinant > 1e-12 * a * e) s = unit((b * f - c * e) / determinant);
    t = unit((b * s + f) / e);
    s = unit((b * t - c) / a);  // best s for the clamped t
  } else if (a > 0.0) {
    s = unit(-c / a);
  } else if (e > 0.0) {
    t = unit(f / e);
  }
  return (r + s * d1 - t * d2).squaredNorm();
}

}  // namespace epcc
