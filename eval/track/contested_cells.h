// SPDX-License-Identifier: BSD-3-Clause
// Places of a map that several planes claim, given to one of them.
#pragma once

#include <Eigen/Core>
#include <map>
#include <utility>

#include "eval/track/surface_grid.h"

namespace epcc {

/// A plane of a map and what was seen of it.
struct ClaimedSurface {
  Eigen::Vector4d plane = Eigen::Vector4d::Zero();  ///< (a, b, c, d), unit normal to the side that it is seen from
  SurfaceGrid seen;
  std::map<int, SurfaceGrid> seen_as;  ///< by label, on the same cells: what another plane has and this one might have
};

/// Takes from each of the surfaces, by label, the cells that belong to another one.
///
/// Where two planes cross noise decides what a pixel is labelled, so that each goes on beyond the other as a strip.
/// Such a strip is known by being the other's: of what was seen on this side of the other plane, and might have been
/// either's, most was called the other's. There the surface ends, and what it has beyond is the other's; what the other
/// one has beyond this one is of no weight. Where a surface does not end at the other one, a cell is that surface's
/// that it was called more often.
void settleContested(std::map<int, ClaimedSurface>& surfaces);

}  // namespace epcc
