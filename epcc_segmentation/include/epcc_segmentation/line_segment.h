// SPDX-License-Identifier: BSD-3-Clause
// A line segment of the image's sections, the paper's list M: what Algorithm 1, or S1, finds in one scan line.
#pragma once

#include <cmath>
#include <cstdint>

#include "epcc_segmentation/parameters.h"
#include "epcc_segmentation/vectors.h"

namespace epcc {

/// A straight run of samples of one image column or row. Its section is the plane through the sensor that the column
/// or row sees, with the coordinates
/// - t1: distance from the scan axis, sqrt(x^2 + z^2) of a column, sqrt(y^2 + z^2) of a row, sqrt(x^2 + y^2) of the
///   column of a spherical scan;
/// - t2: place along the axis, in the order of the pixels: y of a column (-y if y is up), x of a row, -z of a spherical
///   scan.
///
/// The line passes through `mean` along the main axis of `covariance`; in the paper mode these are the prototype's own.
/// In the inverse-depth mode, which grows its lines in inverse depth, they are those of the samples it took, in metres;
/// its samples are those of a grid, every `inverse_depth.stride`-th row and column, and other scan lines have none.
///
/// A scanner may store its rings in another order than that of their elevation, or shifted against each other. `line`,
/// `first` and `last` are those of the cloud then, `first` before `last`, but not all samples need lie between them in
/// that line, and t2 goes by elevation still.
struct LineSegment {
  ScanDirection scan = ScanDirection::Columns;  ///< Columns: part of an image column; Rows: part of a row
  int line = 0;                                 ///< which column or row of the image
  int first = 0;                                ///< where in it the first sample lies: the row, or the column ...
  int last = 0;                                 ///< ... and the last
  /// Samples taken; pixels between first and last that are not measured, were rejected or are not on the grid do not
  /// count.
  int samples = 0;
  /// 0 or the plane of the samples as in PlaneSegmentation::labels; inverse-depth mode: the label that most of them
  /// have.
  std::int32_t label = 0;
  Vector3 start = Vector3::Zero();       ///< first sample, projected on the line (Eq. 21); the sensor's frame, metres
  Vector3 end = Vector3::Zero();         ///< last sample, the same
  Vector2 mean = Vector2::Zero();        ///< of the samples (t1, t2), metres
  Matrix2 covariance = Matrix2::Zero();  ///< of the samples, normalised by n - 1, m^2
  /// Variance of the samples' distances from the line, m^2. Paper mode: sigma_seg^2 by the recursion of Eq. 11, which
  /// takes each distance before the line has learnt from it; inverse-depth mode: the smaller eigenvalue of
  /// `covariance`.
  double variance = 0.0;
  /// The line theta . (t1, t2) = 1 that is likeliest to have given the samples along their rays, 1/m: the normal that
  /// points away from the sensor, divided by the distance from it, so that theta . ray is the inverse depth of a pixel.
  /// Nearly the line through `mean` along the main axis of `covariance`, to which the ends are projected; but that one
  /// is drawn to the near where errors are large and seen at a slant.
  Vector2 theta = Vector2::Zero();
  /// Covariance of theta, 1/m^2: the inverse depth at a ray errs by ray . theta_covariance . ray. From the size of the
  /// residuals, the segment's own and those of the frame's planes, and from how far the error is correlated along the
  /// scan line (docs/research/uncertainty.md). 0 if it is not known: fewer than three samples, or a line of sight.
  Matrix2 theta_covariance = Matrix2::Zero();

  /// The line as t1 cos(alpha) + t2 sin(alpha) = rho: alpha, rad, (-pi, pi].
  double alpha() const { return std::atan2(theta(1), theta(0)); }
  /// Its distance from the sensor, rho, metres.
  double rho() const { return 1.0 / theta.norm(); }
  /// Of (alpha, rho): rad^2, rad m, m^2, to first order. A segment of a few pixels is turned so easily that theta,
  /// which the measurements are linear in, is Gaussian, but these two are not.
  Matrix2 alphaRhoCovariance() const {
    const double r = rho();
    Matrix2 jacobian;
    jacobian << -theta(1), theta(0), -theta(0) * r, -theta(1) * r;
    jacobian *= r * r;
    return jacobian * theta_covariance * jacobian.transpose();
  }

  /// Row of the pixel at a place in the scan line, first to last.
  int row(int position) const { return scan == ScanDirection::Columns ? position : line; }
  /// Column of the pixel at a place in the scan line.
  int column(int position) const { return scan == ScanDirection::Columns ? line : position; }
};

static_assert(sizeof(LineSegment) == 176 && alignof(LineSegment) == alignof(double), "one layout for all flags");

}  // namespace epcc
