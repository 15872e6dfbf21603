// SPDX-License-Identifier: BSD-3-Clause
// The outline of a set of square cells as polygons with holes.
#pragma once

#include <Eigen/Core>
#include <utility>
#include <vector>

namespace epcc {

/// One connected piece: corners in cells, the outline counter-clockwise, its holes clockwise.
struct CellPiece {
  std::vector<Eigen::Vector2d> outline;
  std::vector<std::vector<Eigen::Vector2d>> holes;
};

/// Outlines of the pieces, the largest first. Gaps of up to two cells are closed before; pieces and holes of fewer than
/// `min_cells` are left out (the largest piece never is). Lines are drawn simpler by up to a cell, and never cross
/// themselves or each other. Cells are (column, row); the cell (0, 0) has the corners (0, 0) and (1, 1).
std::vector<CellPiece> cellPieces(const std::vector<std::pair<int, int>>& cells, int min_cells);

}  // namespace epcc
