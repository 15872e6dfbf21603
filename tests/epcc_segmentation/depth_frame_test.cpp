// SPDX-License-Identifier: BSD-3-Clause
// Points of pinhole images, organized clouds and spherical scans.
#include "epcc_segmentation/depth_frame.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "tests/support/rendered_room.h"

namespace {

using epcc::DepthFrame;
using epcc::PinholeCamera;
using epcc::Projection;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();

std::vector<float> pointsOf(const DepthFrame& frame) {
  std::vector<float> xyz;
  Eigen::Vector3d p;
  for (int row = 0; row < frame.height(); ++row)
    for (int column = 0; column < frame.width(); ++column) {
      const bool valid = frame.point(row, column, p);
      for (int k = 0; k < 3; ++k) xyz.push_back(valid ? static_cast<float>(p(k)) : kNan);
    }
  return xyz;
}

TEST(DepthFrame, PinholePointsFollowTheIntrinsics) {
  const PinholeCamera camera{3, 2, 100.0, 200.0, 1.0, 0.5};
  const std::vector<float> depth = {2.0f, 0.0f, -1.0f, kNan, 4.0f, kInf};
  const DepthFrame frame = DepthFrame::fromDepth(depth.data(), camera);
  Eigen::Vector3d p;
  ASSERT_TRUE(frame.point(0, 0, p));
  EXPECT_LT((p - Eigen::Vector3d(-0.02, -0.005, 2.0)).norm(), 1e-12);
  ASSERT_TRUE(frame.point(1, 1, p));
  EXPECT_LT((p - Eigen::Vector3d(0.0, 0.01, 4.0)).norm(), 1e-12);
  for (const auto& [row, column] : {std::pair{0, 1}, {0, 2}, {1, 0}, {1, 2}}) EXPECT_FALSE(frame.point(row, column, p));
}

TEST(DepthFrame, TransposedViewSwapsPixelsAndAxes) {
  const auto room = epcc::test::renderRoom(epcc::test::cornerPlanes(), epcc::test::testCamera(20, 12));
  const DepthFrame frame = room.frame();
  const DepthFrame view = frame.transposed();
  ASSERT_EQ(view.width(), 12);
  ASSERT_EQ(view.height(), 20);
  Eigen::Vector3d p, q;
  for (int row = 0; row < 12; ++row)
    for (int column = 0; column < 20; ++column) {
      ASSERT_EQ(view.index(column, row), frame.index(row, column));
      ASSERT_EQ(frame.scanPoint(row, column, p), view.scanPoint(column, row, q));
      ASSERT_EQ(p.x(), q.y());
      ASSERT_EQ(p.y(), q.x());
      ASSERT_EQ(p.z(), q.z());
      ASSERT_TRUE(view.point(column, row, q));
      ASSERT_EQ(p, q);
    }
}

TEST(DepthFrame, MaskedPixelsAreInvalid) {
  const PinholeCamera camera{2, 1, 1.0, 1.0, 0.0, 0.0};
  const std::vector<float> depth = {1.0f, 1.0f};
  const std::vector<std::uint8_t> mask = {0, 1};
  const DepthFrame frame = DepthFrame::fromDepth(depth.data(), camera).masked(mask.data());
  Eigen::Vector3d p;
  EXPECT_FALSE(frame.point(0, 0, p));
  EXPECT_TRUE(frame.point(0, 1, p));
}

TEST(DepthFrame, RowsOfDepthsAndSlopesAreThoseOfThePoints) {
  const PinholeCamera camera{3, 2, 100.0, 200.0, 1.0, 0.5};
  const std::vector<float> depth = {2.0f, 0.0f, -1.0f, kNan, 4.0f, kInf};
  const std::vector<std::uint8_t> mask = {1, 1, 1, 1, 0, 1};
  const DepthFrame plain = DepthFrame::fromDepth(depth.data(), camera);
  for (const DepthFrame& frame : {plain, plain.transposed(), plain.masked(mask.data())})
    for (int row = 0; row < frame.height(); ++row) {
      std::vector<float> row_depths(static_cast<std::size_t>(frame.width()), -1.0f);
      frame.depthRow(row, row_depths.data());
      for (int column = 0; column < frame.width(); ++column) {
        Eigen::Vector3d p = Eigen::Vector3d::Zero();
        frame.scanPoint(row, column, p);
        const double z = static_cast<double>(row_depths[static_cast<std::size_t>(column)]);
        EXPECT_EQ(z, p.z());
        EXPECT_EQ(z * frame.pinholeAcross(column), p.x());
        EXPECT_EQ(z * frame.pinholeAlong(row), p.y());
      }
    }
}

TEST(DepthFrame, CloudsTakeTheirPointsAsTheyAre) {
  const std::vector<float> cloud = {1, 2, 3, 9, kNan, 2, 3, 9, 1, 2, -3, 9, 1, 2, kInf, 9};
  const DepthFrame frame = DepthFrame::fromPoints(cloud.data(), 4, 2, 2, Projection::Perspective);
  Eigen::Vector3d p;
  ASSERT_TRUE(frame.scanPoint(0, 0, p));
  EXPECT_EQ(p, Eigen::Vector3d(1, 2, 3));
  EXPECT_FALSE(frame.point(0, 1, p));
  EXPECT_FALSE(frame.point(1, 0, p));
  EXPECT_FALSE(frame.point(1, 1, p));
}

TEST(DepthFrame, SphericalScanFrameHasTheAxisAlongTheColumns) {
  const std::vector<float> cloud = {3, 1, 2};
  const DepthFrame frame = DepthFrame::fromPoints(cloud.data(), 3, 1, 1, Projection::Spherical);
  Eigen::Vector3d p;
  ASSERT_TRUE(frame.scanPoint(0, 0, p));
  EXPECT_EQ(p, Eigen::Vector3d(-1, -2, 3));
  EXPECT_NEAR(frame.measuredDepth(p), std::sqrt(14.0), 1e-12);
}

TEST(DepthFrame, NonsenseGivesAnEmptyFrame) {
  const float depth = 1.0f;
  EXPECT_TRUE(DepthFrame::fromDepth(nullptr, {1, 1, 1.0, 1.0, 0.0, 0.0}).empty());
  EXPECT_TRUE(DepthFrame::fromDepth(&depth, {1, 1, 0.0, 1.0, 0.0, 0.0}).empty());
  EXPECT_TRUE(DepthFrame::fromDepth(&depth, {0, 1, 1.0, 1.0, 0.0, 0.0}).empty());
  EXPECT_TRUE(DepthFrame::fromPoints(nullptr, 3, 1, 1, Projection::Perspective).empty());
  EXPECT_TRUE(DepthFrame::fromPoints(&depth, 2, 1, 1, Projection::Perspective).empty());
}

TEST(DetectProjection, TellsPerspectiveFromSpherical) {
  const auto room = epcc::test::renderRoom(epcc::test::cornerPlanes(), epcc::test::testCamera());
  auto xyz = pointsOf(room.frame());
  EXPECT_EQ(epcc::detectProjection(xyz.data(), 3, 160, 120), Projection::Perspective);

  // The same room seen by a scanner: azimuth by column, elevation by row; x forward, y left, z up.
  xyz.clear();
  for (int row = 0; row < 90; ++row)
    for (int column = 0; column < 180; ++column) {
      const double azimuth = (90 - column) * 0.5 * M_PI / 180.0;
      const double elevation = (45 - row) * 0.5 * M_PI / 180.0;
      const Eigen::Vector3d ray(std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
                                std::sin(elevation));
      double nearest = 1e9;
      for (const auto& plane : epcc::test::cornerPlanes()) {
        const Eigen::Vector3d normal(plane(2), -plane(0), -plane(1));
        const double range = -plane(3) / normal.dot(ray);
        if (range > 0.0 && range < nearest) nearest = range;
      }
      for (int k = 0; k < 3; ++k) xyz.push_back(nearest < 1e9 ? static_cast<float>(nearest * ray(k)) : kNan);
    }
  EXPECT_EQ(epcc::detectProjection(xyz.data(), 3, 180, 90), Projection::Spherical);
}

TEST(DetectProjection, TooFewPointsCountAsPerspective) {
  const std::vector<float> cloud(3 * 100, kNan);
  EXPECT_EQ(epcc::detectProjection(cloud.data(), 3, 10, 10), Projection::Perspective);
}

}  // namespace
