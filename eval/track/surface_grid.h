// SPDX-License-Identifier: BSD-3-Clause
// What has been seen of a plane, as square cells on it: grows by what each frame shows.
#pragma once

#include <array>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

#include "epcc_segmentation/surface_polygon.h"

namespace epcc {

/// A cell and how often it was seen.
struct SeenCell {
  int column = 0, row = 0;
  std::uint16_t times = 0;
};

/// Cells on a plane that stays where it was when the grid was made; what is added is put onto it. Memory grows with the
/// area that was seen, not with the number of frames.
class SurfaceGrid {
 public:
  SurfaceGrid() = default;
  /// `plane` (a, b, c, d) with unit normal to the side that it is seen from, `origin` near it; `cell` in metres.
  SurfaceGrid(const Eigen::Vector4d& plane, const Eigen::Vector3d& origin, double cell);
  /// The same cells, none of them seen.
  SurfaceGrid blank() const;

  /// The footprint of some pixels, four points in order, and what was seen once more there: the cells whose middle is
  /// inside, and the one below its own middle if `at_least_one`. One that is not fine adds nothing.
  void add(const std::array<Eigen::Vector3d, 4>& footprint, bool at_least_one = true);
  /// False of a footprint of more than 32 cells a side, which is too coarse to tell anything.
  bool isFine(const std::array<Eigen::Vector3d, 4>& footprint) const;
  /// All cells of another grid, which may lie otherwise.
  void add(const SurfaceGrid& other);
  /// As if it had not been seen.
  void forget(int column, int row);

  /// All cells that were seen, by column and row.
  std::vector<SeenCell> seenCells() const;
  /// Those that were seen at least so often, (column, row).
  std::vector<std::pair<int, int>> cells(int least) const;
  std::uint16_t timesSeen(int column, int row) const;
  /// The middle of a cell.
  Eigen::Vector3d middleOf(const SeenCell& cell) const {
    return basis_.point(Eigen::Vector2d(cell_ * (cell.column + 0.5), cell_ * (cell.row + 0.5)));
  }
  double cell() const { return cell_; }
  /// Coordinates on the plane: (x, y) metres from the origin.
  const PlaneBasis& basis() const { return basis_; }

 private:
  static constexpr int kTile = 16;  // cells along a side
  struct Corners {
    std::array<Eigen::Vector2d, 4> all;  ///< in cells
    Eigen::Vector2d low = Eigen::Vector2d::Constant(1e300), high = -low;
    bool areFine() const;
  };
  using Tile = std::array<std::uint16_t, kTile * kTile>;

  Corners cornersOf(const std::array<Eigen::Vector3d, 4>& footprint) const;
  std::uint16_t& seen(int column, int row);

  PlaneBasis basis_;
  double cell_ = 0.02;
  std::unordered_map<std::uint64_t, Tile> tiles_;  // how often each cell was seen, by the tile's column and row
};

}  // namespace epcc
