// SPDX-License-Identifier: BSD-3-Clause
// Cells are kept by their column and row in one number.
#include "eval/track/surface_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace epcc {
namespace {

constexpr double kMostCells = 32.0;
constexpr double kFarthest = 1e6;  // cells from the origin

std::uint64_t keyOf(int column, int row) {
  return static_cast<std::uint64_t>(static_cast<std::uint32_t>(column)) << 32 | static_cast<std::uint32_t>(row);
}
int columnOf(std::uint64_t key) {
  return static_cast<int>(static_cast<std::uint32_t>(key >> 32));
}
int rowOf(std::uint64_t key) {
  return static_cast<int>(static_cast<std::uint32_t>(key));
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

void SurfaceGrid::see(int column, int row, std::uint16_t times) {
  std::uint16_t& seen = seen_[keyOf(column, row)];
  const unsigned most = std::numeric_limits<std::uint16_t>::max();
  seen = static_cast<std::uint16_t>(std::min<unsigned>(most, static_cast<unsigned>(seen) + times));
}

void SurfaceGrid::add(const std::array<Eigen::Vector3d, 4>& footprint) {
  std::array<Eigen::Vector2d, 4> corners;
  Eigen::Vector2d low(1e300, 1e300), high = -low, middle(0.0, 0.0);
  for (std::size_t i = 0; i < 4; ++i) {
    corners[i] = Eigen::Vector2d(basis_.flat(footprint[i])) / cell_;
    low = low.cwiseMin(corners[i]);
    high = high.cwiseMax(corners[i]);
    middle += 0.25 * corners[i];
  }
  if (!((high - low).maxCoeff() <= kMostCells && low.minCoeff() > -kFarthest && high.maxCoeff() < kFarthest)) return;
  const int own_column = static_cast<int>(std::floor(middle.x())), own_row = static_cast<int>(std::floor(middle.y()));
  for (int row = static_cast<int>(std::floor(low.y())); row <= static_cast<int>(std::floor(high.y())); ++row)
    for (int column = static_cast<int>(std::floor(low.x())); column <= static_cast<int>(std::floor(high.x())); ++column)
      if ((column == own_column && row == own_row) || isInside(corners, {column + 0.5, row + 0.5})) see(column, row, 1);
}

void SurfaceGrid::add(const SurfaceGrid& other) {
  for (const auto& [key, times] : other.seen_) {
    const Eigen::Vector2d middle(other.cell_ * (columnOf(key) + 0.5), other.cell_ * (rowOf(key) + 0.5));
    const Eigen::Vector2d here = Eigen::Vector2d(basis_.flat(other.basis_.point(middle))) / cell_;
    if (here.cwiseAbs().maxCoeff() < kFarthest)
      see(static_cast<int>(std::floor(here.x())), static_cast<int>(std::floor(here.y())), times);
  }
}

std::vector<std::pair<int, int>> SurfaceGrid::cells(int least) const {
  std::vector<std::pair<int, int>> cells;
  for (const auto& [key, times] : seen_)
    if (times >= least) cells.emplace_back(columnOf(key), rowOf(key));
  std::sort(cells.begin(), cells.end());
  return cells;
}

}  // namespace epcc
