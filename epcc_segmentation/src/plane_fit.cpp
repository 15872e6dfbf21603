// SPDX-License-Identifier: BSD-3-Clause
// Moments of the labelled pixels, planes with their covariance, labels in order of size.
#include "plane_fit.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <numeric>

#include "metric/recursive_statistics.h"

namespace epcc {

namespace {

/// Sums over a plane's points about its first point, where double precision loses nothing.
struct PointMoments {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  std::size_t n = 0;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  double weight = 0.0;
  Eigen::Vector3d weighted_sum = Eigen::Vector3d::Zero();
  Eigen::Matrix3d weighted_squares = Eigen::Matrix3d::Zero();

  void add(const Eigen::Vector3d& p, double w) {
    if (n == 0) origin = p;
    const Eigen::Vector3d r = p - origin;
    const Eigen::Matrix3d rr = r * r.transpose();
    ++n;
    sum += r;
    squares += rr;
    weight += w;
    weighted_sum += w * r;
    weighted_squares += w * rr;
  }
};

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

Plane planeOf(const PointMoments& moments, const SensorModel& sensor) {
  Plane plane;
  const double n = static_cast<double>(moments.n);
  const Eigen::Vector3d mean = moments.sum / n;
  plane.pixel_count = moments.n;
  plane.centroid = moments.origin + mean;
  plane.points_covariance = moments.squares / n - mean * mean.transpose();

  const Eigen::Vector3d weighted_mean = moments.weighted_sum / moments.weight;
  const Eigen::Matrix3d scatter = moments.weighted_squares - moments.weight * weighted_mean * weighted_mean.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(scatter);
  Eigen::Vector3d normal = solver.eigenvectors().col(0);
  const Eigen::Vector3d centre = moments.origin + weighted_mean;
  if (normal.dot(centre) > 0.0) normal = -normal;  // towards the sensor
  plane.coefficients << normal, -normal.dot(centre);

  const double mean_distance = plane.signedDistance(plane.centroid);
  const double spread = varianceAlong(plane.points_covariance, normal);
  plane.rms = std::sqrt(spread + mean_distance * mean_distance);
  // Neighbouring errors are alike: N pixels are worth N / pixelsPerSample independent ones.
  const double residual = std::max(0.0, solver.eigenvalues()(0)) / std::max(1.0, n - 3.0);
  plane.coefficients_covariance = coefficientsCovariance(solver.eigenvectors(), solver.eigenvalues(), moments.weight,
                                                         centre, residual * sensor.pixelsPerSample());
  return plane;
}

}  // namespace

void fitPlanes(const DepthFrame& frame, const SensorModel& sensor, int plane_count, PlaneSegmentation& segmentation) {
  std::vector<PointMoments> moments(static_cast<std::size_t>(plane_count));
  Eigen::Vector3d p;
  for (int row = 0; row < frame.height(); ++row)
    for (int column = 0; column < frame.width(); ++column) {
      const std::int32_t label = segmentation.labels[frame.index(row, column)];
      if (label <= 0 || !frame.point(row, column, p)) continue;
      const double sigma = sensor.sigmaZ(isPerspective(frame.projection()) ? std::abs(p.z()) : p.norm());
      moments[static_cast<std::size_t>(label - 1)].add(p, 1.0 / (sigma * sigma));
    }

  std::vector<std::size_t> order(moments.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t i, std::size_t j) { return moments[i].n > moments[j].n; });
  std::vector<std::int32_t> new_label(moments.size() + 1, 0);
  segmentation.planes.clear();
  for (const std::size_t i : order) {
    if (moments[i].n == 0) break;
    segmentation.planes.push_back(planeOf(moments[i], sensor));
    new_label[i + 1] = static_cast<std::int32_t>(segmentation.planes.size());
  }
  for (auto& label : segmentation.labels) label = new_label[static_cast<std::size_t>(label)];
}

}  // namespace epcc
