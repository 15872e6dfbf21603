// SPDX-License-Identifier: BSD-3-Clause
// Joins sums of points about different origins, and fits a plane to them.
#include "point_moments.h"

#include <Eigen/Eigenvalues>
#include <algorithm>

#include "metric/recursive_statistics.h"

namespace epcc {

namespace {

/// Covariance of (normal, d) of the weighted orthogonal fit through `centre`: the normal tilts about the two
/// in-plane axes, the offset moves along it. `unit_variance` is the residual variance of a point of unit weight.
Eigen::Matrix4d coefficientsCovariance(const Eigen::Matrix3d& axes, const Eigen::Vector3d& scatter, double weight,
                                       const Eigen::Vector3d& centre, double unit_variance) {
  Eigen::Matrix3d normal_covariance = Eigen::Matrix3d::Zero();
  for (int k = 1; k < 3; ++k)
    if (scatter(k) > 0.0) normal_covariance += (unit_variance / scatter(k)) * axes.col(k) * axes.col(k).transpose();
  Eigen::Matrix4d covariance;
  covariance.topLeftCorner<3, 3>() = normal_covariance;
  covariance.topRightCorner<3, 1>() = -normal_covariance * centre;
  covariance.bottomLeftCorner<1, 3>() = covariance.topRightCorner<3, 1>().transpose();
  covariance(3, 3) = centre.dot(normal_covariance * centre) + unit_variance / weight;
  return covariance;
}

}  // namespace

void PointSums::add(const double (*lanes)[kSumLanes], const Eigen::Vector3d& shift) {
  double s[kSums];
  for (int k = 0; k < kSums; ++k) s[k] = (lanes[k][0] + lanes[k][2]) + (lanes[k][1] + lanes[k][3]);
  PointSums sums;
  sums.one = s[0];
  sums.first << s[1], s[2], s[3];
  sums.second << s[4], s[5], s[6], s[5], s[7], s[8], s[6], s[8], s[9];
  add(sums, shift);
}

void PointSums::add(const PointSums& others, const Eigen::Vector3d& shift) {
  const Eigen::Vector3d& p = others.first;
  one += others.one;
  first += p + others.one * shift;
  second += others.second + p * shift.transpose() + shift * p.transpose() + others.one * shift * shift.transpose();
}

void PointMoments::add(const LabelSums& sums) {
  if (!sums.started) return;
  const Eigen::Vector3d own(sums.origin[0], sums.origin[1], sums.origin[2]);
  if (plain.one == 0.0) origin = own;
  plain.add(sums.lanes, own - origin);
  weighted.add(sums.lanes + kSums, own - origin);
}

void PointMoments::add(const PointMoments& others) {
  if (others.plain.one == 0.0) return;
  if (plain.one == 0.0) origin = others.origin;
  plain.add(others.plain, others.origin - origin);
  weighted.add(others.weighted, others.origin - origin);
}

PointMoments PointMoments::turned(const Eigen::Matrix3d& axes) const {
  const auto turn = [&axes](const PointSums& sums) {
    PointSums result;
    result.one = sums.one;
    result.first = axes * sums.first;
    result.second = axes * sums.second * axes.transpose();
    return result;
  };
  PointMoments result;
  result.origin = axes * origin;
  result.plain = turn(plain);
  result.weighted = turn(weighted);
  return result;
}

Plane planeOf(const PointMoments& moments, std::size_t pixels, double samples_per_independent) {
  Plane plane;
  const double n = moments.plain.one;
  const double weight = moments.weighted.one;
  const Eigen::Vector3d mean = moments.plain.first / n;
  plane.pixel_count = pixels;
  plane.centroid = moments.origin + mean;
  plane.points_covariance = moments.plain.second / n - mean * mean.transpose();

  const Eigen::Vector3d weighted_mean = moments.weighted.first / weight;
  const Eigen::Matrix3d scatter = moments.weighted.second - weight * weighted_mean * weighted_mean.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(scatter);
  Eigen::Vector3d normal = solver.eigenvectors().col(0);
  const Eigen::Vector3d centre = moments.origin + weighted_mean;
  if (normal.dot(centre) > 0.0) normal = -normal;  // towards the sensor
  plane.coefficients << normal, -normal.dot(centre);

  const double mean_distance = plane.signedDistance(plane.centroid);
  const double spread = varianceAlong(plane.points_covariance, normal);
  plane.rms = std::sqrt(spread + mean_distance * mean_distance);
  const double residual = std::max(0.0, solver.eigenvalues()(0)) / std::max(1.0, n - 3.0);
  plane.coefficients_covariance = coefficientsCovariance(solver.eigenvectors(), solver.eigenvalues(), weight, centre,
                                                         residual * samples_per_independent);
  return plane;
}

}  // namespace epcc
