// SPDX-License-Identifier: BSD-3-Clause
// The result of a segmentation: a label for each pixel and the planes.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace epcc {

/// One plane, in the sensor's frame and in metres.
struct Plane {
  /// (a, b, c, d): a x + b y + c z + d = 0, unit normal towards the sensor (d >= 0).
  Eigen::Vector4d coefficients = Eigen::Vector4d::Zero();
  /// Covariance of (a, b, c, d) from the fit's residuals and the sensor's correlation length.
  Eigen::Matrix4d coefficients_covariance = Eigen::Matrix4d::Zero();
  /// Mean of the plane's points.
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
  /// Covariance of the plane's points about the centroid, normalised by N.
  Eigen::Matrix3d points_covariance = Eigen::Matrix3d::Zero();
  /// Root mean square of the orthogonal distances of the points.
  double rms = 0.0;
  /// Number of pixels.
  std::size_t pixel_count = 0;

  /// Signed distance of a point from the plane, metres, positive on the sensor's side.
  double signedDistance(const Eigen::Vector3d& point) const {
    return coefficients.head<3>().dot(point) + coefficients(3);
  }
  /// Orthogonal projection of a point on the plane (Eq. 28, with the signed distance).
  Eigen::Vector3d project(const Eigen::Vector3d& point) const {
    return point - signedDistance(point) * coefficients.head<3>();
  }
};

/// Labels are row-major: 0 no plane, k the plane planes[k - 1]; planes are sorted by pixel count, largest first.
struct PlaneSegmentation {
  int width = 0;
  int height = 0;
  std::vector<std::int32_t> labels;
  std::vector<Plane> planes;
};

}  // namespace epcc
