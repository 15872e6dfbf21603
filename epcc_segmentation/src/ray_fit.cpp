// SPDX-License-Identifier: BSD-3-Clause
// One Gauss-Newton step in theta = -normal / d, in the patch's own axes.
#include "ray_fit.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>

#include "metric/recursive_statistics.h"
#include "symmetric_part.h"

namespace epcc {

namespace {

/// A side below this many pixels has no slope.
constexpr double kShortestSide = 1.0;

/// The largest step, relative to the inverse depth, that is one between two fits of a plane.
constexpr double kLargestStep = 0.2;

/// Normal equations of the step: information * step = gradient.
struct Normal {
  Eigen::Matrix3d information;
  Eigen::Vector3d gradient;
  double squares;
  double count;
};

Normal normalOf(const ResidualSums& sums) {
  double s[kResidualSums];
  for (int k = 0; k < kResidualSums; ++k)
    s[k] = (sums.lanes[k][0] + sums.lanes[k][2]) + (sums.lanes[k][1] + sums.lanes[k][3]);
  Normal n;
  n.information << s[0], s[1], s[2], s[1], s[3], s[4], s[2], s[4], s[5];
  n.gradient << s[6], s[7], s[8];
  n.squares = s[9];
  n.count = s[10];
  return n;
}

/// The patch as the rays see it. Rows of `axes`: the change of w in its middle, along its long and its short side.
struct Patch {
  Eigen::Matrix3d axes;
  double long_side, short_side;  // pixels
};

double sideOf(double variance) {
  return std::sqrt(12.0 * std::max(0.0, variance));
}

/// Rays (u, v, 1), `information` in pixels.
Patch perspectivePatch(const Eigen::Matrix3d& information) {
  const double weight = information(2, 2);
  const Eigen::Vector2d mean = information.col(2).head<2>() / weight;
  const Eigen::Matrix2d spread = information.topLeftCorner<2, 2>() / weight - mean * mean.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(spread);
  Patch patch;
  patch.axes << mean.transpose(), 1.0, solver.eigenvectors().col(1).transpose(), 0.0,
      solver.eigenvectors().col(0).transpose(), 0.0;
  patch.long_side = sideOf(solver.eigenvalues()(1));
  patch.short_side = sideOf(solver.eigenvalues()(0));
  return patch;
}

/// Rays of unit length.
Patch sphericalPatch(const Eigen::Matrix3d& information) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(information);
  const double weight = information.trace();
  Patch patch;
  patch.axes = solver.eigenvectors().rowwise().reverse().transpose();
  patch.long_side = sideOf(solver.eigenvalues()(1) / weight);
  patch.short_side = sideOf(solver.eigenvalues()(0) / weight);
  return patch;
}

/// Where the pixels' size is not known, the samples fill the patch.
void scaleToArea(double pixels, Patch& patch) {
  const double area = patch.long_side * patch.short_side;
  if (!(area > 0.0)) return;
  const double scale = std::sqrt(pixels / area);
  patch.long_side *= scale;
  patch.short_side *= scale;
}

/// d (a, b, c, d) / d theta, with d = 1 / |theta| and the normal -theta d.
Eigen::Matrix<double, 4, 3> coefficientsByTheta(const Eigen::Vector3d& theta) {
  const double d = 1.0 / theta.norm();
  const Eigen::Vector3d direction = theta * d;
  Eigen::Matrix<double, 4, 3> jacobian;
  jacobian.topRows<3>() = -d * (Eigen::Matrix3d::Identity() - direction * direction.transpose());
  jacobian.row(3) = -d * d * direction.transpose();
  return jacobian;
}

}  // namespace

void addResidualSums(const ResidualSums& band, ResidualSums& sum) {
  for (int k = 0; k < kResidualSums; ++k)
    for (int lane = 0; lane < kSumLanes; ++lane) sum.lanes[k][lane] += band.lanes[k][lane];
}

RayPlane rayPlaneOf(const Plane& plane) {
  RayPlane rays;
  const double d = plane.coefficients(3);
  if (d > 1e-9 * plane.centroid.norm())
    for (int k = 0; k < 3; ++k) rays.theta[k] = -plane.coefficients(k) / d;
  return rays;
}

RayFit fitAlongRays(const ResidualSums& sums, const RayKind& rays, Plane& plane) {
  RayFit fit;
  Normal normal = normalOf(sums);
  if (!(normal.count >= 3.0)) return fit;
  const bool knows_pixels = rays.pixels_u > 0.0;
  const Eigen::Vector3d pixels =
      knows_pixels ? Eigen::Vector3d(rays.pixels_u, rays.pixels_v, 1.0) : Eigen::Vector3d(1.0, 1.0, 1.0);
  normal.information = pixels.asDiagonal() * normal.information * pixels.asDiagonal();
  normal.gradient = pixels.asDiagonal() * normal.gradient;
  Patch patch = rays.is_range ? sphericalPatch(normal.information) : perspectivePatch(normal.information);
  if (!knows_pixels) scaleToArea(normal.count * rays.stride * rays.stride, patch);

  // In the patch's own axes; a side without length says nothing of its slope, which stays.
  const Eigen::Matrix3d theta_of = patch.axes.inverse();
  Eigen::Matrix3d information = theta_of.transpose() * normal.information * theta_of;
  Eigen::Vector3d gradient = theta_of.transpose() * normal.gradient;
  const std::array<double, 3> sides = {kShortestSide, patch.long_side, patch.short_side};
  for (int k = 1; k < 3; ++k) {
    if (sides[static_cast<std::size_t>(k)] >= kShortestSide) continue;
    information.row(k).setZero();
    information.col(k).setZero();
    information(k, k) = 1.0;
    gradient(k) = 0.0;
  }
  const Eigen::LDLT<Eigen::Matrix3d> solver(information);
  const Eigen::Vector3d step = solver.solve(gradient);
  Eigen::Vector3d theta;
  for (int k = 0; k < 3; ++k) theta(k) = -plane.coefficients(k) / plane.coefficients(3);
  const double inverse_depth = std::abs(patch.axes.row(0).dot(pixels.cwiseInverse().asDiagonal() * theta));
  const double change = std::abs(step(0)) + 0.5 * (std::abs(step(1)) * sides[1] + std::abs(step(2)) * sides[2]);
  if (!(change <= kLargestStep * inverse_depth)) return fit;  // the points are of no plane, the orthogonal fit stands
  theta += pixels.asDiagonal() * (theta_of * step);
  plane.coefficients << -theta / theta.norm(), 1.0 / theta.norm();
  const double mean_distance = plane.signedDistance(plane.centroid);
  plane.rms =
      std::sqrt(varianceAlong(plane.points_covariance, plane.coefficients.head<3>()) + mean_distance * mean_distance);

  fit.exists = true;
  fit.inverse = solver.solve(Eigen::Matrix3d::Identity());
  for (int k = 1; k < 3; ++k)
    if (sides[static_cast<std::size_t>(k)] < kShortestSide) fit.inverse(k, k) = 0.0;
  fit.coefficients_by_axes = coefficientsByTheta(theta) * pixels.asDiagonal() * theta_of;
  fit.long_side = patch.long_side;
  fit.short_side = patch.short_side;
  fit.stride = rays.stride;
  fit.squares = std::max(0.0, normal.squares - step.dot(gradient));
  fit.count = normal.count;
  return fit;
}

double RayFit::unit(const SamplesPerIndependent& worth) const {
  const double fitted = worth.offset + worth.long_slope + worth.short_slope;
  return squares / std::max(count - fitted, 0.1 * count);
}

void setCovariance(const RayFit& fit, const ErrorCorrelation& error, Plane& plane) {
  if (!fit.exists) return;
  const SamplesPerIndependent worth = fit.worth(error);
  const Eigen::Vector3d root(std::sqrt(worth.offset), std::sqrt(worth.long_slope), std::sqrt(worth.short_slope));
  const Eigen::Matrix3d inner = fit.unit(worth) * (root.asDiagonal() * fit.inverse * root.asDiagonal());
  plane.coefficients_covariance =
      symmetricPart(fit.coefficients_by_axes * inner * fit.coefficients_by_axes.transpose());
}

}  // namespace epcc
