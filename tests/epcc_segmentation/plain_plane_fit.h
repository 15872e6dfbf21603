// SPDX-License-Identifier: BSD-3-Clause
// The fit of a plane as its definition says, in double precision and without a thought for speed.
#pragma once

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cmath>
#include <vector>

#include "epcc_segmentation/depth_frame.h"
#include "epcc_segmentation/plane_segmentation.h"
#include "epcc_segmentation/sensor_model.h"
#include "tests/support/rendered_room.h"

namespace epcc::test {

/// Fit of one label as its definition says, in double precision, from every stride-th row and column.
inline Plane plainFit(const DepthFrame& frame, const SensorModel& sensor, const std::vector<std::int32_t>& labels,
                      std::int32_t label, int stride, int offset, double samples_per_independent) {
  std::vector<Eigen::Vector3d> points;
  std::vector<double> weights;
  Plane plane;
  Eigen::Vector3d p;
  for (int row = 0; row < frame.height(); ++row)
    for (int column = 0; column < frame.width(); ++column) {
      if (labels[frame.index(row, column)] != label || !frame.point(row, column, p)) continue;
      ++plane.pixel_count;
      if (row % stride != offset || column % stride != offset) continue;
      points.push_back(p);
      weights.push_back(1.0 / sensor.varianceZ(isPerspective(frame.projection()) ? std::abs(p.z()) : p.norm()));
    }
  double weight = 0.0;
  Eigen::Vector3d weighted_mean = Eigen::Vector3d::Zero();
  const auto n = static_cast<double>(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    plane.centroid += points[i] / n;
    weighted_mean += weights[i] * points[i];
    weight += weights[i];
  }
  weighted_mean /= weight;
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < points.size(); ++i) {
    plane.points_covariance += (points[i] - plane.centroid) * (points[i] - plane.centroid).transpose() / n;
    scatter += weights[i] * (points[i] - weighted_mean) * (points[i] - weighted_mean).transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(scatter);
  Eigen::Vector3d normal = solver.eigenvectors().col(0);
  if (normal.dot(weighted_mean) > 0.0) normal = -normal;
  plane.coefficients << normal, -normal.dot(weighted_mean);
  double squares = 0.0;
  for (const auto& point : points) squares += std::pow(plane.signedDistance(point), 2);
  plane.rms = std::sqrt(squares / n);
  const double unit = solver.eigenvalues()(0) / (n - 3.0) * samples_per_independent;
  Eigen::Matrix3d tilt = Eigen::Matrix3d::Zero();
  for (int k = 1; k < 3; ++k)
    tilt += unit / solver.eigenvalues()(k) * solver.eigenvectors().col(k) * solver.eigenvectors().col(k).transpose();
  plane.coefficients_covariance.topLeftCorner<3, 3>() = tilt;
  plane.coefficients_covariance.topRightCorner<3, 1>() = -tilt * weighted_mean;
  plane.coefficients_covariance.bottomLeftCorner<1, 3>() = -(tilt * weighted_mean).transpose();
  plane.coefficients_covariance(3, 3) = weighted_mean.dot(tilt * weighted_mean) + unit / weight;
  return plane;
}

/// The step along the rays as its definition says, from every pixel of the grid: normal equations of theta = -normal /
/// d.
inline Plane plainStep(const DepthFrame& frame, const SensorModel& sensor, const std::vector<std::int32_t>& labels,
                       std::int32_t label, int stride, int offset, Plane plane) {
  const bool is_range = !isPerspective(frame.projection());
  Eigen::Vector3d theta = -Eigen::Vector3d(plane.coefficients.head<3>()) / plane.coefficients(3);
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero(), p;
  for (int row = offset; row < frame.height(); row += stride)
    for (int column = offset; column < frame.width(); column += stride) {
      if (labels[frame.index(row, column)] != label || !frame.point(row, column, p)) continue;
      const double depth = is_range ? p.norm() : std::abs(p.z());
      const Eigen::Vector3d ray = p / depth;
      const double w = theta.dot(ray);
      if (w * depth <= 0.5 || w * depth >= 2.0) continue;
      const double weight = 1.0 / (sensor.varianceZ(1.0 / w) * std::pow(w, 4));
      information += weight * ray * ray.transpose();
      gradient += weight * w * (1.0 - w * depth) * ray;
    }
  theta += information.fullPivLu().solve(gradient);
  plane.coefficients << -theta / theta.norm(), 1.0 / theta.norm();
  plane.rms = std::sqrt(plane.coefficients.head<3>().dot(plane.points_covariance * plane.coefficients.head<3>()) +
                        std::pow(plane.signedDistance(plane.centroid), 2));
  return plane;
}

/// Both steps; the covariance is checked on its own, by what it is to predict.
inline void expectFitted(const Plane& plane, const DepthFrame& frame, const SensorModel& sensor,
                         const std::vector<std::int32_t>& labels, std::int32_t label, int stride, int offset) {
  const auto expected = plainStep(frame, sensor, labels, label, stride, offset,
                                  plainFit(frame, SensorModel::axial(1.0, 0.0), labels, label, stride, offset, 1.0));
  EXPECT_EQ(plane.pixel_count, expected.pixel_count);
  EXPECT_LT((plane.coefficients - expected.coefficients).norm(), 1e-6 * expected.coefficients.norm());
  EXPECT_LT((plane.centroid - expected.centroid).norm(), 1e-6 * expected.centroid.norm());
  EXPECT_LT((plane.points_covariance - expected.points_covariance).norm(), 1e-6 * expected.points_covariance.norm());
  EXPECT_NEAR(plane.rms, expected.rms, 1e-6 * expected.rms);
}

inline void expectNear(const Plane& a, const Plane& b) {
  EXPECT_EQ(a.pixel_count, b.pixel_count);
  EXPECT_LT((a.coefficients - b.coefficients).norm(), 1e-6 * b.coefficients.norm());
  EXPECT_LT((a.centroid - b.centroid).norm(), 1e-6 * b.centroid.norm());
  EXPECT_LT((a.points_covariance - b.points_covariance).norm(), 1e-6 * b.points_covariance.norm());
  EXPECT_NEAR(a.rms, b.rms, 1e-6 * b.rms);
  EXPECT_LT((a.coefficients_covariance - b.coefficients_covariance).norm(), 1e-6 * b.coefficients_covariance.norm());
}

/// A noisy corner of a room with holes, and labels in short and long runs, some of them strangers; `mixed` ones are on
/// points of other planes too.
inline RenderedRoom labelledRoom(int width, int height, bool mixed = true) {
  auto room = renderRoom(cornerPlanes(), testCamera(width, height));
  addNoise(room, SensorModel::axial(0.002, 0.003), 3);
  for (std::size_t i = 0; i < room.depth.size(); ++i) {
    if (i % 11 == 0) room.depth[i] = 0.0f;
    if (i % 13 == 5) room.labels[i] = 0;
    if (mixed && i % 50 < 9) room.labels[i] = static_cast<std::int32_t>(1 + i % 3);
    if (i % 97 == 0) room.labels[i] = 77;
  }
  return room;
}

}  // namespace epcc::test
