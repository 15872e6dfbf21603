// SPDX-License-Identifier: BSD-3-Clause
// Sums over the points of a plane and the plane that they make, for whole frames and for streams.
#pragma once

#include <Eigen/Core>

#include "epcc_segmentation/plane_segmentation.h"
#include "label_sums.h"

namespace epcc {

/// Weighted sums of points.
struct PointSums {
  double one = 0.0;
  Eigen::Vector3d first = Eigen::Vector3d::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();

  /// Of the lanes' sums, about an origin that lies `shift` before theirs.
  void add(const double (*lanes)[kSumLanes], const Eigen::Vector3d& shift);
  /// Of others, likewise.
  void add(const PointSums& others, const Eigen::Vector3d& shift);
};

/// Sums over a plane's points about its first point.
struct PointMoments {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  PointSums plain;
  PointSums weighted;

  void add(const LabelSums& sums);
  void add(const PointMoments& others);
  /// The same of the points times an orthogonal matrix.
  PointMoments turned(const Eigen::Matrix3d& axes) const;
};

/// The plane of at least one point. `samples_per_independent`: neighbouring errors are alike, N samples are worth N /
/// that many independent ones.
Plane planeOf(const PointMoments& moments, std::size_t pixels, double samples_per_independent);

}  // namespace epcc
