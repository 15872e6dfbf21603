// SPDX-License-Identifier: BSD-3-Clause
// Cells are kept in square tiles, for a footprint reaches over a few neighbours.
#include "eval/track/surface_grid.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace epcc {
namespace {

constexpr double kMostCells = 32.0;
constexpr double kFarthestCell = 1e6;  // cells from the origin

/// The tile of a cell, by column or by row, and its place in there.
struct Place {
  Place(int cell, int tile_size) : in_tile((cell % tile_size + tile_size) % tile_size) {
    tile = (cell - in_tile) / tile_size;
  }
  int in_tile, tile = 0;
};

std::uint64_t keyOf(int column, int row) {
  return static_cast<std::uint64_t>(static_cast<std::uint32_t>(column)) << 32 | static_cast<std::uint32_t>(row);
}

void see(std::uint16_t& seen, unsigned times) {
  const unsigned most = std::numeric_limits<std::uint16_t>::max();
  seen = static_cast<std::uint16_t>(std::min(most, seen + times));
}

bool isInside(const std::array<Eigen::Vector2d, 4>& corners, const Eigen::Vector2d& point) {
  bool left = false, right = false;
  for (std::size_t i = 0; i < 4; ++i) {
    const Eigen::Vector2d side = corners[(i + 1) % 4] - corners[i], to = point - corners[i];
    const double cross = side.x() * to.y() - side.y() * to.x();
    left |= cross > 0.0;
    right |= cross < 0.0;
  }
  return !(left && right);
}

}  // namespace

SurfaceGrid::SurfaceGrid(const Eigen::Vector4d& plane, const Eigen::Vector3d& origin, double cell) : cell_(cell) {
  const Eigen::Vector3d normal = plane.head<3>();
  const Eigen::Vector3d helper = std::abs(normal.z()) < 0.7 ? Eigen::Vector3d::UnitZ() : Eigen::Vector3d::UnitX();
  basis_.normal = normal;
  basis_.across = helper.cross(normal).normalized();
  basis_.up = normal.cross(Eigen::Vector3d(basis_.across));
  basis_.origin = origin - normal * (normal.dot(origin) + plane(3));
}

SurfaceGrid SurfaceGrid::blank() const {
  SurfaceGrid same;
  same.basis_ = basis_;
  same.cell_ = cell_;
  return same;
}

std::uint16_t& SurfaceGrid::seen(int column, int row) {
  const Place across(column, kTile), up(row, kTile);
  return tiles_[keyOf(across.tile, up.tile)][static_cast<std::size_t>(up.in_tile * kTile + across.in_tile)];
}

std::uint16_t SurfaceGrid::timesSeen(int column, int row) const {
  const Place across(column, kTile), up(row, kTile);
  const auto tile = tiles_.find(keyOf(across.tile, up.tile));
  return tile == tiles_.end() ? 0 : tile->second[static_cast<std::size_t>(up.in_tile * kTile + across.in_tile)];
}

void SurfaceGrid::forget(int column, int row) {
  const Place across(column, kTile), up(row, kTile);
  const auto tile = tiles_.find(keyOf(across.tile, up.tile));
  if (tile != tiles_.end()) tile->second[static_cast<std::size_t>(up.in_tile * kTile + across.in_tile)] = 0;
}

SurfaceGrid::Corners SurfaceGrid::cornersOf(const std::array<Eigen::Vector3d, 4>& footprint) const {
  Corners corners;
  for (std::size_t i = 0; i < 4; ++i) {
    corners.all[i] = Eigen::Vector2d(basis_.flat(footprint[i])) / cell_;
    corners.low = corners.low.cwiseMin(corners.all[i]);
    corners.high = corners.high.cwiseMax(corners.all[i]);
  }
  return corners;
}

bool SurfaceGrid::Corners::areFine() const {
  return (high - low).maxCoeff() <= kMostCells && low.minCoeff() > -kFarthestCell && high.maxCoeff() < kFarthestCell;
}

bool SurfaceGrid::isFine(const std::array<Eigen::Vector3d, 4>& footprint) const {
  return cornersOf(footprint).areFine();
}

void SurfaceGrid::add(const std::array<Eigen::Vector3d, 4>& footprint, bool at_least_one) {
  const Corners corners = cornersOf(footprint);
  if (!corners.areFine()) return;
  const auto below = [](double value) { return static_cast<int>(std::floor(value)); };
  if (at_least_one) {
    const Eigen::Vector2d middle = 0.25 * (corners.all[0] + corners.all[1] + corners.all[2] + corners.all[3]);
    if (!isInside(corners.all, {below(middle.x()) + 0.5, below(middle.y()) + 0.5}))
      see(seen(below(middle.x()), below(middle.y())), 1);
  }
  // Cells whose middle is between the lowest and the highest corner.
  for (int row = below(corners.low.y() + 0.5); row <= below(corners.high.y() - 0.5); ++row)
    for (int column = below(corners.low.x() + 0.5); column <= below(corners.high.x() - 0.5); ++column)
      if (isInside(corners.all, {column + 0.5, row + 0.5})) see(seen(column, row), 1);
}

void SurfaceGrid::add(const SurfaceGrid& other) {
  for (const SeenCell& cell : other.seenCells()) {
    const Eigen::Vector2d here = Eigen::Vector2d(basis_.flat(other.middleOf(cell))) / cell_;
    if (here.cwiseAbs().maxCoeff() < kFarthestCell)
      see(seen(static_cast<int>(std::floor(here.x())), static_cast<int>(std::floor(here.y()))), cell.times);
  }
}

std::vector<SeenCell> SurfaceGrid::seenCells() const {
  std::vector<SeenCell> cells;
  for (const auto& [key, tile] : tiles_) {
    const int column = kTile * static_cast<int>(static_cast<std::uint32_t>(key >> 32));
    const int row = kTile * static_cast<int>(static_cast<std::uint32_t>(key));
    for (int i = 0; i < kTile * kTile; ++i)
      if (tile[static_cast<std::size_t>(i)] > 0)
        cells.push_back({column + i % kTile, row + i / kTile, tile[static_cast<std::size_t>(i)]});
  }
  std::sort(cells.begin(), cells.end(), [](const SeenCell& a, const SeenCell& b) {
    return a.column != b.column ? a.column < b.column : a.row < b.row;
  });
  return cells;
}

std::vector<std::pair<int, int>> SurfaceGrid::cells(int least) const {
  std::vector<std::pair<int, int>> cells;
  for (const SeenCell& cell : seenCells())
    if (cell.times >= least) cells.emplace_back(cell.column, cell.row);
  return cells;
}

}  // namespace epcc
