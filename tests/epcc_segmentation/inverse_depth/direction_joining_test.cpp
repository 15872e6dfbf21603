// SPDX-License-Identifier: BSD-3-Clause
// S3 against a plain form, and the moments of spherical scans, on every vector unit.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "epcc_segmentation/vector_unit.h"
#include "inverse_depth/direction_joining.h"
#include "tests/epcc_segmentation/inverse_depth/region_fixture.h"

namespace {

using epcc::DirectionalPlanes;
using epcc::InverseDepthImage;
using epcc::InverseDepthParameters;
using epcc::RegionMap;

using epcc::test::imageOf;
using epcc::test::kWhite;

class Joining : public ::testing::TestWithParam<std::string> {
 protected:
  void SetUp() override { ASSERT_TRUE(epcc::setVectorUnit(GetParam())); }
  void TearDown() override { epcc::setVectorUnit(before_); }

 private:
  std::string before_ = epcc::vectorUnit();
};

/// A noisy room with holes, so that planes and segments break.
InverseDepthImage roomImage(int width, int height) {
  auto room = epcc::test::renderRoom(epcc::test::cornerPlanes(), epcc::test::testCamera(width, height));
  epcc::test::addNoise(room, epcc::SensorModel::axial(0.004, 0.0, 0.1), 3);
  for (std::size_t i = 0; i < room.depth.size(); ++i)
    if (i % 97 < 9 || i % 31 == 0) room.depth[i] = 0.0f;
  return imageOf(room);
}

std::array<DirectionalPlanes, 2> grownPlanes(const InverseDepthImage& image, bool columns, bool rows) {
  const InverseDepthParameters parameters;
  std::array<DirectionalPlanes, 2> directions{DirectionalPlanes(true, parameters, kWhite),
                                              DirectionalPlanes(false, parameters, kWhite)};
  directions[0].setActive(columns);
  directions[1].setActive(rows);
  epcc::StripMemory memory;
  memory.growing.configure(parameters);
  for (DirectionalPlanes& direction : directions) {
    direction.beginLines(image, parameters);
    for (int strip = 0; strip < direction.strips(); ++strip) direction.growStrip(image, strip, memory);
    direction.growPlanes(image);
  }
  return directions;
}

/// Pixels of the plane that a pixel belongs to in one direction, 0 if it is in none or in one that is too small.
std::vector<double> planePointsOf(const InverseDepthImage& image, const DirectionalPlanes& direction, bool columns) {
  std::vector<double> points(image.w.size(), 0.0);
  if (!direction.active()) return points;
  std::size_t before = 0;
  for (int line = 0; line < direction.lines().scanLines(); ++line) {
    for (int i = 0; i < (columns ? image.height : image.width); ++i) {
      const std::size_t pixel = columns ? image.index(i, line) : image.index(line, i);
      const std::int32_t segment = direction.lines().segmentOf()[pixel];
      if (segment < 0) continue;
      const int plane = direction.planeOf()[before + static_cast<std::size_t>(segment)];
      points[pixel] = direction.planePoints()[static_cast<std::size_t>(plane)];
    }
    before += static_cast<std::size_t>(direction.lines().lineCount(line));
  }
  return points;
}

TEST_P(Joining, APixelTakesTheLargerOfItsPlanesAndTheLargestIsTheFirst) {
  for (const auto& [width, height] : std::vector<std::pair<int, int>>{{160, 120}, {67, 45}, {5, 90}})
    for (const auto& [columns, rows] : {std::pair{true, true}, std::pair{true, false}, std::pair{false, true}})
      for (const int threads : {1, 3}) {
        const auto image = roomImage(width, height);
        const auto directions = grownPlanes(image, columns, rows);
        RegionMap map;
        epcc::DirectionJoining joining;
        joining.join(image, directions, threads, map);
        joining.join(image, directions, threads, map);  // what it remembers is not that of the last frame
        const auto by_columns = planePointsOf(image, directions[0], true);
        const auto by_rows = planePointsOf(image, directions[1], false);
        std::vector<double> points(map.regions.size() + 1, 0.0);  // of each label's plane
        for (std::size_t i = 0; i < image.w.size(); ++i) {
          const double larger = std::max(by_columns[i], by_rows[i]);
          const std::int32_t label = map.labels[i];
          ASSERT_EQ(label > 0, larger > 0.0) << i;
          ASSERT_LE(label, static_cast<std::int32_t>(map.regions.size()));
          if (label == 0) continue;
          double& known = points[static_cast<std::size_t>(label)];
          ASSERT_TRUE(known == 0.0 || known == larger) << i;
          known = larger;
        }
        points.erase(std::remove(points.begin(), points.end(), 0.0), points.end());
        EXPECT_TRUE(std::is_sorted(points.rbegin(), points.rend()));
        EXPECT_EQ(points.empty(), !columns && width == 5) << "rows of five pixels have no lines";
      }
}

TEST_P(Joining, MomentsOfASphericalScanAreThoseOfItsPixels) {
  auto image = roomImage(67, 45);
  image.planar_rows = false;
  for (std::size_t c = 0; c < image.across.size(); ++c) {
    const double azimuth = 0.03 * static_cast<double>(c) - 0.9;
    image.across[c] = std::sin(azimuth);
    image.forward[c] = std::cos(azimuth);
  }
  std::vector<std::int32_t> labels;
  for (std::size_t i = 0; i < image.w.size(); ++i)  // runs of one to fifteen pixels, over the ends of rows
    labels.push_back(image.w[i] > 0.0f ? static_cast<std::int32_t>(i / (1 + i % 64 / 4) % 4) : 0);
  const auto map = epcc::test::regionsOf(image, labels, 3);
  for (std::int32_t label = 1; label <= 3; ++label) {
    epcc::PlaneMoments brute;
    for (int row = 0; row < image.height; ++row)
      for (int column = 0; column < image.width; ++column) {
        const std::size_t i = image.index(row, column);
        if (labels[i] == label)
          brute.add(image.ray(row, column), static_cast<double>(image.w[i]),
                    1.0 / static_cast<double>(image.weight[i]));
      }
    const auto& region = map.regions[static_cast<std::size_t>(label - 1)];
    ASSERT_GT(brute.n, 50.0);
    EXPECT_EQ(region.n, brute.n);
    EXPECT_LT((region.rays - brute.rays).norm(), 1e-9 * brute.rays.norm());
    EXPECT_LT((region.rays_w - brute.rays_w).norm(), 1e-9 * brute.rays_w.norm());
    EXPECT_NEAR(region.w_w, brute.w_w, 1e-9 * brute.w_w);
    EXPECT_NEAR(region.w_sum, brute.w_sum, 1e-9 * brute.w_sum);
  }
}

INSTANTIATE_TEST_SUITE_P(Units, Joining, ::testing::ValuesIn(epcc::vectorUnits()),
                         [](const auto& unit) { return unit.param; });

}  // namespace
