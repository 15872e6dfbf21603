// SPDX-License-Identifier: BSD-3-Clause
// Outlines of cells whose area is counted, and grids that are filled by footprints.
#include "eval/track/grid_outline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "eval/track/surface_grid.h"

namespace epcc::test {
namespace {

using Cells = std::vector<std::pair<int, int>>;

void addRectangle(Cells& cells, int left, int low, int width, int height) {
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) cells.emplace_back(left + x, low + y);
}

double area(const std::vector<Eigen::Vector2d>& ring) {
  double twice = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Eigen::Vector2d &a = ring[i], &b = ring[(i + 1) % ring.size()];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return 0.5 * twice;
}

double area(const CellPiece& piece) {
  double sum = area(piece.outline);
  for (const auto& hole : piece.holes) sum += area(hole);
  return sum;
}

TEST(CellPieces, OfARectangle) {
  Cells cells;
  addRectangle(cells, -5, 7, 30, 20);
  const std::vector<CellPiece> pieces = cellPieces(cells, 4);
  ASSERT_EQ(pieces.size(), 1U);
  EXPECT_EQ(pieces[0].outline.size(), 4U);
  EXPECT_DOUBLE_EQ(area(pieces[0]), 600.0);
  EXPECT_EQ(pieces[0].outline[0], Eigen::Vector2d(-5, 7));
  EXPECT_TRUE(cellPieces({}, 4).empty());
}

TEST(CellPieces, HaveHolesAndComeLargestFirst) {
  Cells cells;
  addRectangle(cells, 40, 0, 10, 10);
  for (const auto& [x, y] : [] {
         Cells all;
         addRectangle(all, 0, 0, 30, 30);
         return all;
       }())
    if (x < 10 || x >= 20 || y < 10 || y >= 20) cells.emplace_back(x, y);
  const std::vector<CellPiece> pieces = cellPieces(cells, 4);
  ASSERT_EQ(pieces.size(), 2U);
  ASSERT_EQ(pieces[0].holes.size(), 1U);
  EXPECT_DOUBLE_EQ(area(pieces[0]), 800.0);
  EXPECT_LT(area(pieces[0].holes[0]), 0.0) << "clockwise";
  EXPECT_DOUBLE_EQ(area(pieces[1]), 100.0);
}

TEST(CellPieces, CloseGapsAndDropWhatIsSmall) {
  Cells cells;
  addRectangle(cells, 0, 0, 20, 20);
  addRectangle(cells, 22, 0, 20, 20);  // two cells apart
  addRectangle(cells, 60, 0, 2, 2);
  EXPECT_EQ(cellPieces(cells, 10).size(), 1U);
  EXPECT_EQ(cellPieces(cells, 4).size(), 2U);
  EXPECT_NEAR(area(cellPieces(cells, 10)[0]), 840.0, 10.0);
  const Cells speck = {{3, 3}};
  ASSERT_EQ(cellPieces(speck, 100).size(), 1U) << "the largest is never dropped";
  EXPECT_DOUBLE_EQ(area(cellPieces(speck, 100)[0]), 1.0);
}

TEST(CellPieces, FillSmallHolesAndWhatIsInThem) {
  Cells cells;
  for (int y = 0; y < 30; ++y)
    for (int x = 0; x < 30; ++x)
      if (x < 10 || x >= 20 || y < 10 || y >= 20) cells.emplace_back(x, y);
  addRectangle(cells, 14, 14, 2, 2);  // four cells from the rest on all sides
  ASSERT_EQ(cellPieces(cells, 4).size(), 2U);
  EXPECT_EQ(cellPieces(cells, 4)[0].holes.size(), 1U);
  ASSERT_EQ(cellPieces(cells, 5).size(), 1U) << "the piece in the hole";
  EXPECT_EQ(cellPieces(cells, 5)[0].holes.size(), 1U);
  ASSERT_EQ(cellPieces(cells, 101).size(), 1U);
  EXPECT_TRUE(cellPieces(cells, 101)[0].holes.empty());
  EXPECT_DOUBLE_EQ(area(cellPieces(cells, 101)[0]), 900.0);
}

TEST(CellPieces, CellsThatShareACornerAreTwoPieces) {
  Cells cells;
  addRectangle(cells, 0, 0, 10, 10);
  addRectangle(cells, 10, 10, 10, 10);
  double sum = 0.0;
  for (const CellPiece& piece : cellPieces(cells, 1)) sum += area(piece);
  EXPECT_NEAR(sum, 200.0, 4.0) << "the closing fills the corner";
}

/// Even-odd: whether a point is inside.
bool isInside(const CellPiece& piece, const Eigen::Vector2d& p) {
  bool inside = false;
  const auto cross = [&](const std::vector<Eigen::Vector2d>& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Eigen::Vector2d &a = ring[i], &b = ring[(i + 1) % ring.size()];
      if ((a.y() <= p.y()) != (b.y() <= p.y()) && a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()) > p.x())
        inside = !inside;
    }
  };
  cross(piece.outline);
  for (const auto& hole : piece.holes) cross(hole);
  return inside;
}

TEST(CellPieces, CoverRandomCells) {
  std::mt19937 random(5);
  for (int round = 0; round < 20; ++round) {
    Cells cells;
    for (int k = 0; k < 25; ++k)
      addRectangle(cells, static_cast<int>(random() % 60), static_cast<int>(random() % 60),
                   3 + static_cast<int>(random() % 15), 3 + static_cast<int>(random() % 15));
    const std::vector<CellPiece> pieces = cellPieces(cells, 6);
    long missed = 0;
    for (const auto& [x, y] : cells) {
      bool inside = false;
      for (const CellPiece& piece : pieces) inside |= isInside(piece, {x + 0.5, y + 0.49});
      missed += inside ? 0 : 1;
    }
    EXPECT_LT(static_cast<double>(missed), 0.05 * static_cast<double>(cells.size())) << round;
    for (std::size_t i = 1; i < pieces.size(); ++i) EXPECT_GE(area(pieces[i - 1].outline), area(pieces[i].outline));
  }
}

TEST(SurfaceGrid, TakesFootprintsOfSlantedPlanes) {
  const Eigen::Vector3d normal = Eigen::Vector3d(1, 2, 3).normalized(), place(0.3, -0.2, 0.5);
  const Eigen::Vector4d plane(normal.x(), normal.y(), normal.z(), -normal.dot(place));
  SurfaceGrid grid(plane, place, 0.01);
  const PlaneBasis& basis = grid.basis();
  EXPECT_NEAR((Eigen::Vector3d(basis.across).cross(Eigen::Vector3d(basis.up)) - normal).norm(), 0.0, 1e-12);
  const auto at = [&](double x, double y) { return Eigen::Vector3d(basis.point(Eigen::Vector2d(x, y))); };
  grid.add({at(0, 0), at(0.1, 0), at(0.1, 0.2), at(0, 0.2)});
  EXPECT_NEAR(static_cast<double>(grid.cells(1).size()), 200.0, 31.0);
  EXPECT_TRUE(grid.cells(2).empty());
  grid.add({at(0.001, 0.001), at(0.002, 0.001), at(0.002, 0.002), at(0.001, 0.002)});
  ASSERT_EQ(grid.cells(2).size(), 1U) << "one smaller than a cell";
  EXPECT_EQ(grid.cells(2)[0], std::pair(0, 0));
  const std::size_t before = grid.cells(1).size();
  grid.add({at(0, 0), at(5, 0), at(5, 5), at(0, 5)});
  EXPECT_EQ(grid.cells(1).size(), before) << "too coarse";

  SurfaceGrid other(plane, place + 0.5 * Eigen::Vector3d(basis.across), 0.01);
  other.add(grid);
  const auto moved = other.cells(1);
  EXPECT_NEAR(static_cast<double>(moved.size()), static_cast<double>(before), 30.0);
  EXPECT_NEAR(moved.front().first, -50, 1);
}

}  // namespace
}  // namespace epcc::test
