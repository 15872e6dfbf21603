// SPDX-License-Identifier: BSD-3-Clause
// Closed lines drawn with fewer points.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace epcc {

/// A closed line; the last point and the first are joined, too.
using Ring = std::vector<Eigen::Vector2d>;

/// The rings of one piece, none of them farther than `most` from what it was, and no line crosses or touches another
/// but in points that both had; as they are where that cannot be had.
std::vector<Ring> drawnSimpler(const std::vector<Ring>& rings, double most);

}  // namespace epcc
