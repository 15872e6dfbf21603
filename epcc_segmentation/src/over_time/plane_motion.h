// SPDX-License-Identifier: BSD-3-Clause
// How planes of a map look from a camera, and how they change when it moves a little.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>

#include "epcc_segmentation/vectors.h"

namespace epcc {

/// A plane (n, d) in the camera's frame from one in the map's: n . x + d keeps its value.
inline Eigen::Vector4d planeSeenFrom(const Eigen::Isometry3d& camera_to_map, const Eigen::Vector4d& plane) {
  return camera_to_map.matrix().transpose() * plane;
}

/// d(n, d)/d(ω, v) of a plane seen from a camera that turns by ω, then shifts by v, in its own frame.
inline Eigen::Matrix<double, 4, 6> planeByMotion(const Eigen::Vector4d& seen) {
  Eigen::Matrix<double, 4, 6> j = Eigen::Matrix<double, 4, 6>::Zero();
  j.block<3, 3>(0, 0) << 0, -seen(2), seen(1), seen(2), 0, -seen(0), -seen(1), seen(0), 0;  // n x ω
  j.block<1, 3>(3, 3) = seen.head<3>().transpose();
  return j;
}

/// dθ/d(n, d) of θ = -n/d.
inline Eigen::Matrix<double, 3, 4> inverseByPlane(const Eigen::Vector4d& plane) {
  Eigen::Matrix<double, 3, 4> j;
  j.leftCols<3>() = Eigen::Matrix3d::Identity() * (-1.0 / plane(3));
  j.col(3) = plane.head<3>() / (plane(3) * plane(3));
  return j;
}

/// A turn by ω, then a shift by v, as UncertainPose takes them.
inline Eigen::Isometry3d moved(const Eigen::Isometry3d& pose, const Eigen::Matrix<double, 6, 1>& motion) {
  Eigen::Isometry3d step = Eigen::Isometry3d::Identity();
  const double angle = motion.head<3>().norm();
  if (angle > 0.0) step.linear() = Eigen::AngleAxisd(angle, motion.head<3>() / angle).toRotationMatrix();
  step.translation() = motion.tail<3>();
  return pose * step;
}

}  // namespace epcc
