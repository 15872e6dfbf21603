// SPDX-License-Identifier: BSD-3-Clause
// The plane that is likeliest to have given the depths along their rays, and the covariance of its coefficients.
#pragma once

#include <Eigen/Core>

#include "correlated_error.h"
#include "epcc_segmentation/plane_segmentation.h"
#include "ray_residuals.h"

namespace epcc {

/// What the rays of a plane's samples are.
struct RayKind {
  bool is_range = false;                  ///< of unit length, the depth is a range; else (u, v, 1)
  double pixels_u = 0.0, pixels_v = 0.0;  ///< pixels per unit of u and v; 0: not known, the samples fill their area
  int stride = 1;                         ///< a sample at every stride-th row and column
};

/// What a fit along rays leaves to be said once it is known how the error is correlated.
struct RayFit {
  bool exists = false;
  Eigen::Matrix3d inverse = Eigen::Matrix3d::Zero();  ///< of the information, in the patch's axes
  Eigen::Matrix<double, 4, 3> coefficients_by_axes = Eigen::Matrix<double, 4, 3>::Zero();  ///< d (a, b, c, d)
  double long_side = 0.0, short_side = 0.0;                                                ///< of the patch, pixels
  int stride = 1;
  double squares = 0.0;  ///< of the residuals, in units of the sensor model
  double count = 0.0;

  /// Mean square of the error, in units of the sensor model.
  double unit(const SamplesPerIndependent& worth) const;
  SamplesPerIndependent worth(const ErrorCorrelation& error) const {
    return samplesPerIndependent(error, long_side, short_side, stride);
  }
};

/// Sums of the bands in order.
void addResidualSums(const ResidualSums& band, ResidualSums& sum);

/// theta of a plane's coefficients; nothing counts (all 0) if it passes through the sensor.
RayPlane rayPlaneOf(const Plane& plane);

/// Moves `plane` (coefficients given, as the sums were made with) to the least squares of what the samples are off
/// along their rays, each weighted by 1 / sigma_z^2 at the plane's own depth, and sets coefficients and rms. One step
/// from the orthogonal fit: rays do not err, so that, unlike in orthogonal least squares and with weights from measured
/// depths, errors do not bias the plane; what is left is of second order in sigma_z / z. Without three samples that
/// count, for a plane through the sensor, and where the step is a large one because the points are of no plane, all
/// stays as the orthogonal fit has it.
RayFit fitAlongRays(const ResidualSums& sums, const RayKind& rays, Plane& plane);

/// Sets the covariance of the plane's coefficients: that of the residuals' own size, whatever the sensor model's, and
/// of the error's correlation. Leaves it if there is no fit.
void setCovariance(const RayFit& fit, const ErrorCorrelation& error, Plane& plane);

}  // namespace epcc
