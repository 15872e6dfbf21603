// SPDX-License-Identifier: BSD-3-Clause
// Lines drawn through the middle of the pixels' steps.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace epcc {

/// Corners on a line of few points all lie on one side of it: each of its sides is moved until as much of the corners'
/// line is to its left as to its right. Returns by how much each of the `kept` corners (numbers from `begin` on, places
/// from 0 on) moves, less than a pixel. The ends stay, unless the line is closed and `is_whole`: then they are one
/// corner that moves, too.
std::vector<Eigen::Vector2d> balancedShifts(const std::vector<Eigen::Vector2d>& places,
                                            const std::vector<std::size_t>& kept, std::size_t begin, bool is_whole);

}  // namespace epcc
