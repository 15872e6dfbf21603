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

/// Cells on a plane that stays where it was when the grid was made; what is added is put onto it. Memory grows with the
/// area that was seen, not with the number of frames.
class SurfaceGrid {
 public:
  SurfaceGrid() = default;
  /// `plane` (a, b, c, d) with unit normal to the side that it is seen from, `origin` near it; `cell` in metres.
  SurfaceGrid(const Eigen::Vector4d& plane, const Eigen::Vector3d& origin, double cell);

  /// The footprint of a pixel, four points in order, and what was seen once more there: the cells whose middle is
  /// inside, and the one below its own middle. One of more than 32 cells a side is too coarse to tell anything: nothing
  /// is added.
  void add(const std::array<Eigen::Vector3d, 4>& footprint);
  /// All cells of another grid, which may lie otherwise.
  void add(const SurfaceGrid& other);

  /// Cells that were seen at least so often, (column, row).
  std::vector<std::pair<int, int>> cells(int least) const;
  double cell() const { return cell_; }
  /// Coordinates on the plane: (x, y) metres from the origin.
  const PlaneBasis& basis() const { return basis_; }

 private:
  void see(int column, int row, std::uint16_t times);

  PlaneBasis basis_;
  double cell_ = 0.02;
  std::unordered_map<std::uint64_t, std::uint16_t> seen_;
};

}  // namespace epcc
