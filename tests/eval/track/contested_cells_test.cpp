// SPDX-License-Identifier: BSD-3-Clause
// A floor and a wall that claim parts of each other.
#include "eval/track/contested_cells.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace epcc::test {
namespace {

constexpr double kCellSize = 0.05;
constexpr int kFloor = 1, kWall = 2;
const Eigen::Vector4d kFloorPlane(0, 0, 1, 0), kWallPlane(0, -1, 0, 2);  // the wall at y = 2, seen from y < 2

/// Times that a rectangle between two corners of the floor, or of the wall, was seen.
void seeFloor(SurfaceGrid& grid, double left, double near, double right, double far, int times) {
  for (int k = 0; k < times; ++k)
    grid.add({Eigen::Vector3d(left, near, 0), {right, near, 0}, {right, far, 0}, {left, far, 0}});
}
void seeWall(SurfaceGrid& grid, double left, double low, double right, double high, int times) {
  for (int k = 0; k < times; ++k)
    grid.add({Eigen::Vector3d(left, 2, low), {right, 2, low}, {right, 2, high}, {left, 2, high}});
}

std::map<int, ClaimedSurface> floorAndWall() {
  std::map<int, ClaimedSurface> surfaces;
  surfaces[kFloor] = {kFloorPlane, SurfaceGrid(kFloorPlane, {0, 0, 0}, kCellSize), {}};
  surfaces[kWall] = {kWallPlane, SurfaceGrid(kWallPlane, {0, 2, 0}, kCellSize), {}};
  surfaces[kFloor].seen_as[kWall] = surfaces[kFloor].seen.blank();
  surfaces[kWall].seen_as[kFloor] = surfaces[kWall].seen.blank();
  return surfaces;
}

/// How far the cells of a surface reach along a direction, by their middles.
std::pair<double, double> reach(const SurfaceGrid& grid, const Eigen::Vector3d& along) {
  std::pair<double, double> reach(1e9, -1e9);
  for (const SeenCell& cell : grid.seenCells()) {
    reach.first = std::min(reach.first, along.dot(grid.middleOf(cell)));
    reach.second = std::max(reach.second, along.dot(grid.middleOf(cell)));
  }
  return reach;
}

TEST(ContestedCells, SurfacesEndWhereTheirPlanesCross) {
  std::map<int, ClaimedSurface> surfaces = floorAndWall();
  ClaimedSurface &floor = surfaces[kFloor], &wall = surfaces[kWall];
  seeFloor(floor.seen, 0, 1, 1, 2, 10);
  seeFloor(floor.seen, 0, 2, 1, 2.2, 3);
  seeFloor(floor.seen, 0, 2, 1, 2.05, 5);            // along the wall what is behind it is called floor more often
  seeFloor(floor.seen_as[kWall], 0, 1.8, 1, 2, 12);  // rays to what the wall has below the floor
  seeFloor(floor.seen_as[kWall], 0, 2, 1, 2.3, 5);
  seeWall(wall.seen, 0, 0, 1, 1, 10);
  seeWall(wall.seen, 0, -0.2, 1, 0, 4);
  seeWall(wall.seen_as[kFloor], 0, -0.3, 1, 0, 12);
  seeWall(wall.seen_as[kFloor], 0, 0, 1, 0.2, 5);
  const std::size_t floor_cells = floor.seen.cells(10).size(), wall_cells = wall.seen.cells(10).size();
  settleContested(surfaces);
  EXPECT_LT(reach(floor.seen, Eigen::Vector3d::UnitY()).second, 2.0);
  EXPECT_GT(reach(wall.seen, Eigen::Vector3d::UnitZ()).first, 0.0);
  EXPECT_EQ(floor.seen.cells(1).size(), floor_cells) << "all in front of the wall, though more rays were called wall";
  EXPECT_EQ(wall.seen.cells(1).size(), wall_cells);
}

TEST(ContestedCells, WhatNobodyElseClaimsStays) {
  std::map<int, ClaimedSurface> surfaces = floorAndWall();
  ClaimedSurface& floor = surfaces[kFloor];
  seeFloor(floor.seen, 0, 1, 1, 2, 10);
  seeFloor(floor.seen, 1.2, 2, 2, 2.2, 3);  // through a door
  seeFloor(floor.seen, 0, 2, 1, 2.2, 3);
  seeFloor(floor.seen_as[kWall], 0, 2, 1, 2.2, 9);
  seeWall(surfaces[kWall].seen, 0, 0, 1, 1, 10);
  settleContested(surfaces);
  EXPECT_EQ(floor.seen.cells(1).size(), 20U * 20U + 16U * 4U);
  EXPECT_NEAR(reach(floor.seen, Eigen::Vector3d::UnitY()).second, 2.2 - 0.5 * kCellSize, 1e-6);
}

TEST(ContestedCells, WhereASurfaceGoesOnMostVotesDecide) {
  std::map<int, ClaimedSurface> surfaces = floorAndWall();
  ClaimedSurface &floor = surfaces[kFloor], &wall = surfaces[kWall];
  seeFloor(floor.seen, 0, 1, 1, 2, 10);
  seeFloor(floor.seen, 0, 2, 1, 3, 10);  // round a box that has the wall as its front
  seeFloor(floor.seen_as[kWall], 0, 2, 0.5, 2.2, 11);
  seeFloor(floor.seen_as[kWall], 0.5, 2, 1, 2.2, 9);
  seeWall(wall.seen, 0, 0, 1, 1, 10);
  settleContested(surfaces);
  EXPECT_EQ(floor.seen.cells(1).size(), 20U * 40U - 10U * 4U);
  EXPECT_EQ(wall.seen.cells(1).size(), 20U * 20U);
}

// Each is behind the other for its rays: no edge looks like that, and both would lose the same.
TEST(ContestedCells, NoRayIsTakenFromBoth) {
  std::map<int, ClaimedSurface> surfaces = floorAndWall();
  ClaimedSurface &floor = surfaces[kFloor], &wall = surfaces[kWall];
  seeFloor(floor.seen, 0, 1, 1, 2, 10);
  seeFloor(floor.seen, 0, 2, 1, 2.2, 3);
  seeFloor(floor.seen_as[kWall], 0, 2, 1, 2.2, 2);  // called the floor more often
  seeFloor(floor.seen_as[kWall], 0, 2.1, 1, 2.2, 5);
  seeWall(wall.seen, 0, -1, 1, 0, 10);
  seeWall(wall.seen, 0, 0, 1, 0.2, 3);
  seeWall(wall.seen_as[kFloor], 0, 0, 1, 0.2, 5);
  settleContested(surfaces);
  EXPECT_EQ(floor.seen.cells(1).size(), 20U * 22U);
  EXPECT_EQ(wall.seen.cells(1).size(), 20U * 20U) << "by votes";
}

}  // namespace
}  // namespace epcc::test
