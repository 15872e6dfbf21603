// SPDX-License-Identifier: BSD-3-Clause
// First where each surface ends, for all pairs; then which cells it loses.
#include "eval/track/contested_cells.h"

#include <vector>

namespace epcc {
namespace {

enum class LostSide { None, Front, Behind };  // of another plane; front is where that one is seen from

LostSide sideOf(const SurfaceGrid& grid, const SeenCell& cell, const Eigen::Vector4d& plane) {
  return plane.head<3>().dot(grid.middleOf(cell)) + plane(3) < 0.0 ? LostSide::Behind : LostSide::Front;
}

/// The side of another plane that a surface does not reach: none where that holds of neither side, or of both.
LostSide lostSide(const ClaimedSurface& surface, const SurfaceGrid& seen_as_other, const Eigen::Vector4d& other) {
  long own_behind = 0, own_front = 0, theirs_behind = 0, theirs_front = 0;
  for (const SeenCell& cell : surface.seen.seenCells()) {
    const bool is_behind = sideOf(surface.seen, cell, other) == LostSide::Behind;
    (is_behind ? own_behind : own_front) += cell.times;
    (is_behind ? theirs_behind : theirs_front) += seen_as_other.timesSeen(cell.column, cell.row);
  }
  const bool loses_behind = theirs_behind > own_behind, loses_front = theirs_front > own_front;
  if (loses_behind == loses_front) return LostSide::None;
  return loses_behind ? LostSide::Behind : LostSide::Front;
}

}  // namespace

void settleContested(std::map<int, ClaimedSurface>& surfaces) {
  std::map<std::pair<int, int>, LostSide> lost_sides;
  for (const auto& [label, surface] : surfaces)
    for (const auto& [other, seen_as] : surface.seen_as)
      lost_sides[{label, other}] = lostSide(surface, seen_as, surfaces.at(other).plane);

  for (auto& [label, surface] : surfaces) {
    std::vector<SeenCell> lost;
    for (const auto& [other, seen_as] : surface.seen_as) {
      LostSide own_lost = lost_sides.at({label, other});
      const auto back = lost_sides.find({other, label});
      LostSide their_lost = back == lost_sides.end() ? LostSide::None : back->second;
      // An edge is concave, and both end behind each other, or convex. Else rays could be taken from both.
      if (own_lost != LostSide::None && their_lost != LostSide::None && own_lost != their_lost)
        own_lost = their_lost = LostSide::None;
      for (const SeenCell& cell : surface.seen.seenCells()) {
        const long theirs = seen_as.timesSeen(cell.column, cell.row);
        if (theirs == 0) continue;
        const LostSide side = sideOf(surface.seen, cell, surfaces.at(other).plane);
        // A ray that meets this plane in front of the other one meets that one behind this one.
        const LostSide their_side = side == LostSide::Front ? LostSide::Behind : LostSide::Front;
        if (side == own_lost || (their_side != their_lost && theirs > cell.times)) lost.push_back(cell);
      }
    }
    for (const SeenCell& cell : lost) surface.seen.forget(cell.column, cell.row);
  }
}

}  // namespace epcc
