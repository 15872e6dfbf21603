// SPDX-License-Identifier: BSD-3-Clause
// A scanner has no forward direction: what it finds does not depend on the heading.
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <random>
#include <vector>

#include "epcc_segmentation/plane_extractor.h"
#include "inverse_depth/plane_batch.h"
#include "tests/support/vector_units.h"

namespace {

using epcc::PlaneMoments;

constexpr double kDegree = M_PI / 180.0;

/// Rays of a piece of a wall with noise, as a scanner sees it whose x and z axes are turned by `heading`.
PlaneMoments wallPiece(double heading) {
  std::mt19937 generator(7);
  std::normal_distribution<double> normal(0.0, 0.002);
  PlaneMoments moments;
  moments.turning = true;
  const Eigen::Vector2d normal_of_wall(std::sin(heading + 0.6), std::cos(heading + 0.6));
  for (int column = 0; column < 40; ++column)
    for (int row = 0; row < 20; ++row) {
      const double azimuth = heading + 0.004 * (column - 20), v = 0.01 * (row - 10);
      const Eigen::Vector3d ray(std::sin(azimuth), v, std::cos(azimuth));
      const double w = 0.3 * (normal_of_wall.x() * ray.x() + normal_of_wall.y() * ray.z()) + 0.1 * v;
      moments.add(ray, w + normal(generator), 4e-6);
    }
  return moments;
}

TEST(ScanHeading, PlanesAndSlopesTurnWithTheScanner) {
  const epcc::RegionPlane ahead(wallPiece(0.0));
  EXPECT_NEAR(ahead.slope_factor, 1.0 + std::pow(std::tan(0.6), 2) + std::pow(0.1 / (0.3 * std::cos(0.6)), 2), 0.06);
  for (int degrees = 15; degrees < 360; degrees += 15) {
    SCOPED_TRACE(degrees);
    const double heading = degrees * kDegree;
    const epcc::RegionPlane turned(wallPiece(heading));
    EXPECT_NEAR(turned.slope_factor, ahead.slope_factor, 1e-6);
    EXPECT_NEAR(turned.rss, ahead.rss, 1e-5 * ahead.rss);
    const double across = std::cos(heading) * turned.q.x() - std::sin(heading) * turned.q.z();
    EXPECT_NEAR(across, ahead.q.x(), 1e-6);
    EXPECT_NEAR(turned.q.y(), ahead.q.y(), 1e-6);
  }
}

TEST(ScanHeading, RegionsInLanesHaveTheSamePlanesToTheBit) {
  epcc::PlaneBatch batch;
  std::vector<epcc::RegionSums> regions;
  for (int k = 0; k < epcc::PlaneBatch::kSize; ++k) {
    regions.emplace_back(wallPiece(k * 23.0 * kDegree));
    batch.add(regions.back());
  }
  epcc::test::onEveryVectorUnit([&] {
    epcc::fitPlanes(batch);
    for (int k = 0; k < batch.count; ++k) {
      const epcc::SumsPlane expected(regions[static_cast<std::size_t>(k)]);
      EXPECT_EQ(batch.plane(k).x, expected.x);
      EXPECT_EQ(batch.plane(k).z, expected.z);
      EXPECT_EQ(batch.plane(k).rss, expected.rss);
      EXPECT_EQ(batch.plane(k).slope_factor, expected.slope_factor);
      const epcc::RegionPlane plane(wallPiece(k * 23.0 * kDegree));
      EXPECT_NEAR(expected.rss, plane.rss, 1e-5 * plane.rss);
      EXPECT_NEAR(expected.slope_factor, plane.slope_factor, 1e-6);
    }
  });
}

/// A lidar of `rings` rings between -20 and 20 degrees in the middle of a box, 1024 columns, white noise of 10 mm.
struct LidarRoom {
  int rings;
  int columns = 1024;
  std::vector<float> xyz;
  std::vector<int> face;  ///< 0 to 3 the walls, 4 floor, 5 ceiling

  LidarRoom(int ring_count, double heading) : rings(ring_count) {
    std::mt19937 generator(static_cast<unsigned>(rings));
    std::normal_distribution<double> noise(0.0, 0.01);
    const double distance[] = {3.1, 4.3, 2.6, 5.2, 1.7, 1.1};
    for (int ring = 0; ring < rings; ++ring)
      for (int column = 0; column < columns; ++column) {
        const double elevation = (20.0 - 40.0 * ring / (rings - 1)) * kDegree;
        const double azimuth = M_PI - 2.0 * M_PI * (column + 0.5) / columns;
        const Eigen::Vector3d ray(std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
                                  std::sin(elevation));
        const double c = std::cos(heading), s = std::sin(heading);
        const double toward[] = {c * ray.x() + s * ray.y(),
                                 -s * ray.x() + c * ray.y(),
                                 -c * ray.x() - s * ray.y(),
                                 s * ray.x() - c * ray.y(),
                                 -ray.z(),
                                 ray.z()};
        double range = std::numeric_limits<double>::max();
        int hit = -1;
        for (int k = 0; k < 6; ++k)
          if (toward[k] > 0.0 && distance[k] / toward[k] < range) {
            range = distance[k] / toward[k];
            hit = k;
          }
        range += noise(generator);
        for (int k = 0; k < 3; ++k) xyz.push_back(static_cast<float>(range * ray(k)));
        face.push_back(hit);
      }
  }

  /// Of the pixels of a face, the part that its foremost label has.
  double foundPart(int which, const std::vector<std::int32_t>& labels) const {
    std::vector<int> count(1, 0);
    int all = 0;
    for (std::size_t i = 0; i < labels.size(); ++i) {
      if (face[i] != which) continue;
      ++all;
      const auto label = static_cast<std::size_t>(labels[i]);
      if (label >= count.size()) count.resize(label + 1, 0);
      if (label > 0) ++count[label];
    }
    return static_cast<double>(*std::max_element(count.begin(), count.end())) / all;
  }
};

class LidarRooms : public testing::TestWithParam<int> {
 protected:
  /// The parts of the walls that are found at headings of 15 degrees each.
  void expectWalls(const std::optional<epcc::SensorModel>& sensor) const {
    for (int degrees = 0; degrees < 90; degrees += 15) {
      SCOPED_TRACE(degrees);
      // A wall that the seam cuts in the middle has two labels.
      const LidarRoom room(GetParam(), degrees * kDegree);
      epcc::PlaneExtractor extractor(epcc::Parameters(), sensor);
      epcc::PlaneSegmentation result;
      ASSERT_TRUE(extractor.extract(
          epcc::DepthFrame::fromPoints(room.xyz.data(), 3, room.columns, room.rings, epcc::Projection::Spherical),
          result))
          << extractor.error();
      for (int wall = 0; wall < 4; ++wall) EXPECT_GT(room.foundPart(wall, result.labels), 0.45) << "wall " << wall;
      for (const epcc::Plane& plane : result.planes) EXPECT_LT(plane.rms, 0.03);
    }
  }
};

TEST_P(LidarRooms, EveryWallIsFoundAtEveryHeading) {
  expectWalls(epcc::SensorModel::parse("0.01,0,1"));
}

TEST_P(LidarRooms, EveryWallIsFoundIfNothingIsSaidOfTheSensor) {
  expectWalls(std::nullopt);
}

/// A wall that a scanner without error sees from 70 to 75 degrees to its side: from column to column the depth changes
/// by many times what a pixel is wide.
TEST(ScanHeading, ExactScannersSeeSlantedWalls) {
  const int columns = 100, rings = 60;
  std::vector<float> xyz;
  for (int ring = 0; ring < rings; ++ring)
    for (int column = 0; column < columns; ++column) {
      const double azimuth = (60.0 - 0.05 * column) * kDegree, v = 0.001 * (30 - ring);
      const double distance = 0.5 / std::sin(azimuth - 40.0 * kDegree);
      for (const double value : {std::cos(azimuth), std::sin(azimuth), v})
        xyz.push_back(static_cast<float>(distance * value));
    }
  epcc::Parameters as_given;
  as_given.inverse_depth.adapt_sensor = false;
  epcc::PlaneExtractor extractor(as_given, epcc::SensorModel::parse("0.0001,0,1"));
  epcc::PlaneSegmentation result;
  ASSERT_TRUE(extractor.extract(
      epcc::DepthFrame::fromPoints(xyz.data(), 3, columns, rings, epcc::Projection::Spherical), result));
  ASSERT_EQ(result.planes.size(), 1u);
  EXPECT_GT(result.planes[0].pixel_count, 0.95 * columns * rings);
}

INSTANTIATE_TEST_SUITE_P(Rings, LidarRooms, testing::Values(16, 64, 128));

}  // namespace
