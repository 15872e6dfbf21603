// SPDX-License-Identifier: BSD-3-Clause
// Sizes, distances and tilts of planes whose geometry is known.
#include "eval/segment/plane_report.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace {

using epcc::DepthFrame;
using epcc::PinholeCamera;
using epcc::Plane;
using epcc::PlaneSegmentation;
using epcc::PlaneSummary;

constexpr int kWidth = 60;
constexpr int kHeight = 40;
const PinholeCamera kCamera{kWidth, kHeight, 100.0, 100.0, 29.5, 19.5};

PlaneSegmentation onePlane(const Eigen::Vector4d& coefficients, const std::vector<float>& depth) {
  PlaneSegmentation result;
  result.width = kWidth;
  result.height = kHeight;
  Plane plane;
  plane.coefficients = coefficients;
  for (const float z : depth) {
    result.labels.push_back(z > 0.0F ? 1 : 0);
    plane.pixel_count += z > 0.0F ? 1U : 0U;
  }
  plane.centroid = -coefficients(3) * coefficients.head<3>();
  plane.rms = 0.0042;
  result.planes.push_back(plane);
  return result;
}

// Depth of the plane in each pixel.
std::vector<float> render(const Eigen::Vector4d& plane) {
  std::vector<float> depth;
  for (int row = 0; row < kHeight; ++row) {
    for (int column = 0; column < kWidth; ++column) {
      const Eigen::Vector3d ray((column - kCamera.cx) / kCamera.fx, (row - kCamera.cy) / kCamera.fy, 1.0);
      const double z = -plane(3) / plane.head<3>().dot(ray);
      depth.push_back(z > 0.0 && z < 20.0 ? static_cast<float>(z) : 0.0F);
    }
  }
  return depth;
}

PlaneSummary summaryOf(const Eigen::Vector4d& plane) {
  const std::vector<float> depth = render(plane);
  return summarizePlanes(DepthFrame::fromDepth(depth.data(), kCamera), onePlane(plane, depth)).at(0);
}

TEST(PlaneReport, FrontalWall) {
  const PlaneSummary wall = summaryOf(Eigen::Vector4d(0.0, 0.0, -1.0, 2.0));
  EXPECT_EQ(wall.id, 1);
  EXPECT_EQ(wall.pixels, 2400U);
  EXPECT_NEAR(wall.area, 2400 * 0.02 * 0.02, 1e-4);
  EXPECT_NEAR(wall.distance, 2.0, 1e-9);
  EXPECT_NEAR(wall.centroid_distance, 2.0, 1e-9);
  EXPECT_NEAR(wall.tilt, 90.0, 1e-6);
  EXPECT_EQ(wall.kind, "wall-like");
}

TEST(PlaneReport, SlantedWallHasItsTrueArea) {
  const double angle = 0.9;
  const PlaneSummary wall = summaryOf(Eigen::Vector4d(std::sin(angle), 0.0, -std::cos(angle), 2.0));
  // dA = z^3 / d du dv
  double area = 0.0;
  for (const float z : render(Eigen::Vector4d(std::sin(angle), 0.0, -std::cos(angle), 2.0)))
    area += std::pow(z, 3) / 2e4;
  EXPECT_NEAR(wall.area, area, 0.03 * area);
}

TEST(PlaneReport, NamesFloorCeilingAndSlope) {
  EXPECT_EQ(summaryOf(Eigen::Vector4d(0.0, -1.0, 0.0, 1.2)).kind, "floor-like");
  EXPECT_EQ(summaryOf(Eigen::Vector4d(0.0, 1.0, 0.0, 1.2)).kind, "ceiling-like");
  const PlaneSummary slope = summaryOf(Eigen::Vector4d(0.0, -std::sqrt(0.5), -std::sqrt(0.5), 1.0));
  EXPECT_EQ(slope.kind, "slanted");
  EXPECT_NEAR(slope.tilt, 45.0, 1e-6);
}

TEST(PlaneReport, UpIsZInASphericalScan) {
  std::vector<float> xyz;
  for (int row = 0; row < kHeight; ++row) {
    for (int column = 0; column < kWidth; ++column) {
      const double azimuth = 0.01 * column;
      const double range = 1.0 + 0.05 * row;
      xyz.push_back(static_cast<float>(range * std::cos(azimuth)));
      xyz.push_back(static_cast<float>(range * std::sin(azimuth)));
      xyz.push_back(-1.0F);
    }
  }
  const DepthFrame frame = DepthFrame::fromPoints(xyz.data(), 3, kWidth, kHeight, epcc::Projection::Spherical);
  const std::vector<float> all(static_cast<std::size_t>(kWidth) * kHeight, 1.0F);
  const PlaneSummary floor = summarizePlanes(frame, onePlane(Eigen::Vector4d(0.0, 0.0, 1.0, 1.0), all)).at(0);
  EXPECT_EQ(floor.kind, "floor-like");
  EXPECT_NEAR(floor.tilt, 0.0, 1e-6);
  EXPECT_GT(floor.area, 1.0);
}

TEST(PlaneReport, ASinglePixelHasNoArea) {
  std::vector<float> depth(static_cast<std::size_t>(kWidth) * kHeight, 0.0F);
  depth[777] = 2.0F;
  const auto result = onePlane(Eigen::Vector4d(0.0, 0.0, -1.0, 2.0), depth);
  EXPECT_EQ(summarizePlanes(DepthFrame::fromDepth(depth.data(), kCamera), result).at(0).area, 0.0);
}

TEST(PlaneReport, TableHasAHeaderAndALineAPlane) {
  const PlaneSummary wall = summaryOf(Eigen::Vector4d(0.0, 0.0, -1.0, 2.0));
  EXPECT_EQ(epcc::planeTable({wall, wall}, "  "),
            "  plane   pixels  area m2  distance m  centroid m  tilt deg  kind          rms mm  confidence\n"
            "      1     2400    0.960       2.000       2.000      90.0  wall-like        4.2        1.00\n"
            "      1     2400    0.960       2.000       2.000      90.0  wall-like        4.2        1.00\n");
}

}  // namespace
