// SPDX-License-Identifier: BSD-3-Clause
// Where the camera is, from planes of a map and what is seen of them.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "epcc_segmentation/known_planes.h"

namespace epcc {

/// What a frame sees of a plane: the normal equations of its inverse depth, M θ = b, in variances that allow for
/// correlation.
struct SeenPlane {
  Eigen::Matrix3d rays = Eigen::Matrix3d::Zero();    ///< M
  Eigen::Vector3d rays_w = Eigen::Vector3d::Zero();  ///< b
  double samples = 0.0;                              ///< independent ones
};

struct AlignedPose {
  UncertainPose pose;
  Matrix6 information = Matrix6::Zero();  ///< of the planes alone
  std::vector<double> squared_error;      ///< per plane, -1 if too little is seen of it
};

/// The pose that brings the planes of the map and what is seen of them together, as far as the expected pose allows:
/// Gauss-Newton over all planes at once, a plane that does not fit has a weight that sinks with its error (Cauchy), so
/// that what has moved of its own does not drag the camera along. `error_scale` >= 1 times the covariances of what is
/// seen is the error that planes really have.
AlignedPose alignPose(const std::vector<MapPlane>& planes, const std::vector<SeenPlane>& seen,
                      const UncertainPose& expected, double error_scale);

}  // namespace epcc
