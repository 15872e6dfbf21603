// SPDX-License-Identifier: BSD-3-Clause
// The result of a segmentation: a label for each pixel and the planes.
#pragma once

#include <cstdint>
#include <vector>

#include "epcc_segmentation/doubts.h"
#include "epcc_segmentation/line_segment.h"
#include "epcc_segmentation/vectors.h"

namespace epcc {

/// One plane, in metres and in the sensor's frame, or in that of a cloud that is not in the sensor's (CloudGeometry).
struct Plane {
  /// (a, b, c, d): a x + b y + c z + d = 0, unit normal towards the sensor (d >= 0 if that is at the origin).
  Vector4 coefficients = Vector4::Zero();
  /// Covariance of (a, b, c, d), of rank 3, from the size of the fit's residuals, and from how far the error is
  /// correlated: by the sensor model's length, or as it was measured where the sensor is
  /// (docs/research/uncertainty.md). Where the sensor is measured, its slow bending is in it too.
  Matrix4 coefficients_covariance = Matrix4::Zero();
  /// Mean of the plane's points, metres.
  Vector3 centroid = Vector3::Zero();
  /// Covariance of the plane's points about the centroid, normalised by N, m^2.
  Matrix3 points_covariance = Matrix3::Zero();
  /// Root mean square of the orthogonal distances of the points, metres.
  double rms = 0.0;
  /// Number of pixels.
  std::size_t pixel_count = 0;
  /// How likely this is a surface and not clutter, 0 to 1, by its size, roughness and thickness (S9 of the
  /// inverse-depth mode, InverseDepthParameters::min_confidence). 1 in the paper mode, which does not ask.
  double confidence = 1.0;

  /// Signed distance of a point from the plane, metres, positive on the sensor's side.
  double signedDistance(const Eigen::Vector3d& point) const {
    return coefficients.head<3>().dot(point) + coefficients(3);
  }
  /// Orthogonal projection of a point on the plane (Eq. 28, with the signed distance).
  Eigen::Vector3d project(const Eigen::Vector3d& point) const {
    return point - signedDistance(point) * coefficients.head<3>();
  }
};
static_assert(sizeof(Plane) == 35 * sizeof(double) && alignof(Plane) == alignof(double), "one layout for all flags");

/// The result of a segmentation. Labels are row-major: 0 no plane, k the plane planes[k - 1]; planes are sorted by
/// pixel count, largest first.
struct PlaneSegmentation {
  int width = 0;                     ///< columns of the frame
  int height = 0;                    ///< rows of the frame
  std::vector<std::int32_t> labels;  ///< of pixel (row, column) at [row * width + column]: 0, or k for planes[k - 1]
  std::vector<Plane> planes;         ///< that of most pixels first
  /// The line segments of all scan lines if Parameters::line_segments asks for them: those of the columns, then those
  /// of the rows; scan line by scan line, and in order along each. The inverse-depth mode has scan lines at every
  /// `inverse_depth.stride`-th column and row, of an image 640 pixels wide columns and rows 1, 3, 5, ...
  std::vector<LineSegment> segments;
  /// What makes the planes doubtful. The paper mode with a given sensor, which measures nothing, has none.
  Doubts doubts;
};

}  // namespace epcc
