// SPDX-License-Identifier: BSD-3-Clause
// The pose from planes: right where they say something, expected where they do not.
#include "over_time/pose_alignment.h"

#include <gtest/gtest.h>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <cmath>
#include <random>
#include <vector>

#include "over_time/plane_motion.h"

namespace epcc {
namespace {

/// What a camera sees of a plane without error, over a square field of view.
SeenPlane seenFrom(const Eigen::Isometry3d& camera, const Eigen::Vector4d& plane) {
  const Eigen::Vector4d seen = planeSeenFrom(camera, plane);
  const Eigen::Vector3d theta = -seen.head<3>() / seen(3);
  SeenPlane result;
  for (int i = -5; i <= 5; ++i)
    for (int j = -5; j <= 5; ++j) {
      const Eigen::Vector3d ray(0.1 * i, 0.1 * j, 1.0);
      const double weight = 1.0 / (0.001 * 0.001);
      result.rays += weight * ray * ray.transpose();
      result.rays_w += weight * theta.dot(ray) * ray;
      result.samples += 1.0;
    }
  return result;
}

MapPlane mapPlane(const Eigen::Vector3d& normal, double d) {
  MapPlane plane;
  plane.coefficients << normal.normalized(), d;
  plane.covariance = 1e-8 * Matrix4::Identity();
  return plane;
}

UncertainPose expectedAt(const Eigen::Isometry3d& camera) {
  UncertainPose pose;
  pose.camera_to_map = camera;
  pose.covariance = 0.03 * 0.03 * Matrix6::Identity();
  return pose;
}

const std::vector<MapPlane> kCorner = {mapPlane({0.0, 0.1, -1.0}, 3.0), mapPlane({1.0, 0.0, -0.2}, 1.5),
                                       mapPlane({0.0, -1.0, -0.1}, 1.2)};

// Where planes of the map are hardly known, the products that it is made of are large.
TEST(PoseAlignment, WhatPlanesSayIsSymmetricHoweverLittleIsKnownOfThem) {
  for (const double variance : {1e-8, 1.0, 1e8, 1e16}) {
    std::vector<MapPlane> planes = kCorner;
    std::vector<SeenPlane> seen;
    for (MapPlane& plane : planes) {
      plane.covariance = variance * Matrix4::Identity();
      seen.push_back(seenFrom(Eigen::Isometry3d::Identity(), plane.coefficients));
    }
    const AlignedPose aligned = alignPose(planes, seen, expectedAt(Eigen::Isometry3d::Identity()), 1.0);
    const Matrix6 asymmetry = aligned.information - aligned.information.transpose();
    EXPECT_LE(asymmetry.cwiseAbs().maxCoeff(), 1e-12 * aligned.information.cwiseAbs().maxCoeff()) << variance;
  }
}

TEST(PoseAlignment, ThreePlanesSayWhereTheCameraIs) {
  Eigen::Matrix<double, 6, 1> motion;
  motion << 0.01, -0.02, 0.015, 0.02, -0.03, 0.01;
  const Eigen::Isometry3d truth = moved(Eigen::Isometry3d::Identity(), motion);
  std::vector<SeenPlane> seen;
  for (const MapPlane& plane : kCorner) seen.push_back(seenFrom(truth, plane.coefficients));
  const AlignedPose aligned = alignPose(kCorner, seen, expectedAt(Eigen::Isometry3d::Identity()), 1.0);
  const Eigen::Isometry3d error = truth.inverse() * Eigen::Isometry3d(aligned.pose.camera_to_map);
  EXPECT_LT(error.translation().norm(), 1e-4);
  EXPECT_LT(Eigen::AngleAxisd(error.linear()).angle(), 1e-4);
  for (const double square : aligned.squared_error) EXPECT_LT(square, 0.1);
}

TEST(PoseAlignment, NothingIsInventedAlongOpenDirections) {
  Eigen::Isometry3d truth = Eigen::Isometry3d::Identity();
  truth.translation() << 0.05, 0.04, 0.02;
  const std::vector<MapPlane> wall = {mapPlane({0.0, 0.0, -1.0}, 3.0)};
  const AlignedPose aligned =
      alignPose(wall, {seenFrom(truth, wall[0].coefficients)}, expectedAt(Eigen::Isometry3d::Identity()), 1.0);
  const Eigen::Vector3d shift = Eigen::Isometry3d(aligned.pose.camera_to_map).translation();
  EXPECT_NEAR(shift.z(), 0.02, 1e-3);
  EXPECT_NEAR(shift.x(), 0.0, 1e-6);
  EXPECT_NEAR(shift.y(), 0.0, 1e-6);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> solver(
      Eigen::Matrix<double, 6, 6>(aligned.information));
  const auto values = solver.eigenvalues();
  EXPECT_LT(values(2), 1e-6 * values(5)) << "two shifts and the turn about the normal are open";
  EXPECT_GT(values(3), 1e-6 * values(5));
}

TEST(PoseAlignment, APlaneThatMovedOfItsOwnDoesNotDragTheCamera) {
  std::vector<MapPlane> planes = kCorner;
  planes.push_back(mapPlane({0.1, 0.0, -1.0}, 2.5));
  planes.push_back(mapPlane({-0.3, 0.0, -1.0}, 2.0));
  std::vector<SeenPlane> seen;
  for (const MapPlane& plane : planes) seen.push_back(seenFrom(Eigen::Isometry3d::Identity(), plane.coefficients));
  Eigen::Vector4d pushed = planes.back().coefficients;
  pushed(3) += 0.2;
  seen.back() = seenFrom(Eigen::Isometry3d::Identity(), pushed);
  const AlignedPose aligned = alignPose(planes, seen, expectedAt(Eigen::Isometry3d::Identity()), 1.0);
  EXPECT_LT(Eigen::Isometry3d(aligned.pose.camera_to_map).translation().norm(), 2e-3);
  EXPECT_GT(aligned.squared_error.back(), 1000.0);
}

// Planes that are known and seen better than the pose by many powers of ten, as absurd sensors give them.
TEST(PoseAlignment, VariancesAreThoseExpectedOrLessAndNeverNegative) {
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> power(-10.0, 10.0);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 2000; ++i) {
    std::vector<MapPlane> planes = kCorner;
    std::vector<SeenPlane> seen;
    for (MapPlane& plane : planes) {
      plane.coefficients(3) *= std::pow(10.0, 0.3 * power(generator));
      // Known along one direction alone, with an error of rounding across it: a variance below zero.
      const Eigen::Vector4d along(normal(generator), normal(generator), normal(generator), normal(generator));
      plane.covariance = Eigen::Matrix4d(std::pow(10.0, power(generator)) *
                                         (along * along.transpose() - 1e-12 * Eigen::Matrix4d::Identity()));
      seen.push_back(seenFrom(Eigen::Isometry3d::Identity(), plane.coefficients));
      seen.back().rays *= std::pow(10.0, power(generator));
    }
    const UncertainPose expected = expectedAt(Eigen::Isometry3d::Identity());
    const Matrix6 covariance = alignPose(planes, seen, expected, 1.0).pose.covariance;
    ASSERT_EQ(covariance, covariance.transpose());
    ASSERT_GE(covariance.diagonal().minCoeff(), 0.0) << i;
    ASSERT_LE((covariance.diagonal() - expected.covariance.diagonal()).maxCoeff(), 1e-6) << i;
  }
}

TEST(PoseAlignment, TooLittleSeenSaysNothing) {
  SeenPlane little = seenFrom(Eigen::Isometry3d::Identity(), kCorner[0].coefficients);
  little.samples = 3.0;
  const AlignedPose aligned = alignPose({kCorner[0]}, {little}, expectedAt(Eigen::Isometry3d::Identity()), 1.0);
  EXPECT_EQ(aligned.squared_error[0], -1.0);
  EXPECT_EQ(aligned.information.norm(), 0.0);
}

}  // namespace
}  // namespace epcc
