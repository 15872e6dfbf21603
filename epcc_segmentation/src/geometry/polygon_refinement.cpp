// SPDX-License-Identifier: BSD-3-Clause
// Which arcs are to be drawn finer: the nearest to a flaw, and those that change an area most.
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "geometry/polygon_building.h"

namespace epcc {

namespace {

constexpr int kPatience = 24;          // flaws that are looked for one by one
constexpr double kShareOfBlame = 0.5;  // of the arc that changes an area most: those that are drawn finer with it

double distanceToSegment(const Eigen::Vector2d& p, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  const Eigen::Vector2d along = b - a;
  const double square = along.squaredNorm();
  const double share = square > 0.0 ? std::clamp((p - a).dot(along) / square, 0.0, 1.0) : 0.0;
  return (p - a - share * along).norm();
}

/// Of the corners first..last.
std::size_t nearestCorner(const std::vector<Vector2>& corners, std::size_t first, std::size_t last,
                          const Vector2& place) {
  std::size_t nearest = first;
  for (std::size_t i = first; i <= last; ++i)
    if ((corners[i] - place).squaredNorm() < (corners[nearest] - place).squaredNorm()) nearest = i;
  return nearest;
}

}  // namespace

/// Whether leaving out corners and rings changes the area by little enough.
bool PolygonBuilder::isSimple(Region& region, OutlineArcs& outlines) const {
  const std::vector<LabelRing>& rings = outlines.arcs().rings;
  std::map<int, double> changes;  // by arc
  double change = 0.0;
  for (const Ring& ring : region.rings) {
    if (ring.is_left_out) continue;
    for (const LabelRing::Part& part : rings[static_cast<std::size_t>(ring.ring)].parts) {
      const DrawnArc& arc = outlines.drawn(part.arc);
      const double of_part = region.turn * (part.is_reversed ? -arc.change[1] : arc.change[0]);
      changes[part.arc] += of_part;
      change += of_part;
    }
  }
  if (std::abs(change) <= 0.5 * options_.max_area_change * std::abs(region.area)) return true;
  // The arcs to blame, and no others: each loses a straight line.
  double most = 0.0;
  const auto blame = [&](int arc, double of_arc) {
    return outlines.drawn(arc).scale > 0.0 ? std::copysign(1.0, change) * of_arc : 0.0;
  };
  for (const auto& [arc, of_arc] : changes) most = std::max(most, blame(arc, of_arc));
  for (const auto& [arc, of_arc] : changes)
    if (most > 0.0 && blame(arc, of_arc) >= kShareOfBlame * most) outlines.refineArea(arc);
  return !(most > 0.0);
}

/// False if nothing can be drawn finer. What is not valid again and again is drawn as the pixels have it, which is.
bool PolygonBuilder::refineAt(int label, const Region& region, const Vector2& place, OutlineArcs& outlines) const {
  const auto [blamed, corner] = arcAt(label, region, place, outlines);
  if (region.flaws < kPatience && blamed >= 0) {
    outlines.refine(blamed, corner);
    return true;
  }
  bool can_refine = false;
  for (const Ring& own : region.rings)
    for (const LabelRing::Part& part : outlines.arcs().rings[static_cast<std::size_t>(own.ring)].parts) {
      can_refine = can_refine || outlines.canRefine(part.arc);
      outlines.release(part.arc);
    }
  return can_refine;
}

/// The arc nearest to a place, of those that can be drawn finer there, and its corner; -1 if there is none.
std::pair<int, std::size_t> PolygonBuilder::arcAt(int label, const Region& region, const Vector2& place,
                                                  const OutlineArcs& outlines) const {
  double nearest = std::numeric_limits<double>::infinity();
  std::pair<int, std::size_t> found{-1, 0};
  for (const Ring& own : region.rings) {
    for (const LabelRing::Part& part : outlines.arcs().rings[static_cast<std::size_t>(own.ring)].parts) {
      const DrawnArc& arc = outlines.drawn(part.arc);
      Vector2 before = Vector2::Zero();
      for (std::size_t i = 0; i < arc.vertices.size(); ++i) {
        const Vector2 flat = planes_.flat(label, outlines.vertexPoint(label, part.arc, arc.vertices[i]));
        const double distance = distanceToSegment(place, i > 0 ? before : flat, flat);
        before = flat;
        if (distance >= nearest) continue;
        const std::size_t first = arc.vertices[i > 0 ? i - 1 : i].corner;
        const std::size_t corner =
            nearestCorner(arc.flat[part.is_reversed ? 1 : 0], first, arc.vertices[i].corner, place);
        if (!outlines.canRefine(part.arc, corner)) continue;
        nearest = distance;
        found = {part.arc, corner};
      }
    }
  }
  return found;
}

}  // namespace epcc
