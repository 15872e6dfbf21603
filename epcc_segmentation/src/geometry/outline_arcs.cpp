// SPDX-License-Identifier: BSD-3-Clause
// Runs on common lines are replaced by their ends; what is between them is drawn simpler.
#include "geometry/outline_arcs.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "geometry/balanced_lines.h"
#include "geometry/flat_cross.h"

namespace epcc {

namespace {

constexpr double kLeastScale = 0.1;
constexpr std::size_t kFineCorners = 6;  // to either side of a flaw
constexpr std::size_t kLeastBent = 6;    // corners: in a shorter line a bend is as large as a step

}  // namespace

OutlineArcs::OutlineArcs(const PixelRays& rays, const SensorModel& sensor, const PolygonOptions& options,
                         const OutlinePlanes& planes, const LabelArcs& arcs, PlaneCreases& creases)
    : rays_(rays),
      sensor_(sensor),
      options_(options),
      planes_(planes),
      arcs_(arcs),
      creases_(creases),
      drawn_(arcs.arcs.size()),
      is_dirty_(arcs.arcs.size(), 1) {
  for (std::size_t i = 0; i < drawn_.size(); ++i) {
    const LabelArc& arc = arcs_.arcs[i];
    for (int side = 0; side < 2; ++side) {
      const int label = side == 0 ? arc.left : arc.right;
      if (label <= 0 || !planes_.exists(label)) continue;
      std::vector<Vector2>& flat = drawn_[i].flat[side];
      flat.reserve(arc.corners.size());
      for (const int corner : arc.corners)
        flat.push_back(planes_.flat(label, planes_.corner(label, arcs_.row(corner), arcs_.column(corner))));
    }
    findRuns(static_cast<int>(i));
  }
  std::vector<int> changed;
  settleJunctions(changed);
  for (DrawnArc& drawn : drawn_) drawn.is_closed_up = options_.close_edges;
}

double OutlineArcs::place(int corner, bool row) const {
  return (row ? arcs_.row(corner) : arcs_.column(corner)) - 0.5;
}

const PlaneCrease* OutlineArcs::crease(int arc) {
  const LabelArc& own = arcs_.arcs[static_cast<std::size_t>(arc)];
  if (own.left <= 0 || own.right <= 0 || own.left == own.right) return nullptr;
  return creases_.find(std::min(own.left, own.right), std::max(own.left, own.right));
}

void OutlineArcs::findRuns(int arc) {
  const PlaneCrease* line = crease(arc);
  if (line == nullptr) return;
  const std::vector<int>& corners = arcs_.arcs[static_cast<std::size_t>(arc)].corners;
  for (std::size_t begin = 0, end = 0; begin < corners.size(); begin = end + 1) {
    const auto isNear = [&](std::size_t i) { return line->isNear(place(corners[i], false), place(corners[i], true)); };
    end = begin;
    if (!isNear(begin)) continue;
    while (end + 1 < corners.size() && isNear(end + 1)) ++end;
    if (end - begin < static_cast<std::size_t>(options_.edges.min_pixels)) continue;
    // A whole ring near the line is an island beside it: on the line it would be a point.
    if (begin == 0 && end + 1 == corners.size() && corners.front() == corners.back()) continue;
    CreaseRun run;
    run.begin = begin;
    run.end = end;
    run.first = line->nearestPoint(place(corners[begin], false), place(corners[begin], true));
    run.last = line->nearestPoint(place(corners[end], false), place(corners[end], true));
    drawn_[static_cast<std::size_t>(arc)].runs.push_back(run);
  }
}

void OutlineArcs::refine(int arc, std::size_t corner) {
  DrawnArc& drawn = drawn_[static_cast<std::size_t>(arc)];
  is_dirty_[static_cast<std::size_t>(arc)] = 1;
  if (!isSimplifiedAt(drawn, corner)) {
    drawn.is_closed_up = false;
    return;
  }
  drawn.is_fine.resize(arcs_.arcs[static_cast<std::size_t>(arc)].corners.size(), 0);
  const std::size_t end = std::min(corner + kFineCorners + 1, drawn.is_fine.size());
  for (std::size_t i = corner - std::min(corner, kFineCorners); i < end; ++i) drawn.is_fine[i] = 1;
}

/// Whether corners near this one, of which no common line takes the place, may be left out.
bool OutlineArcs::isSimplifiedAt(const DrawnArc& drawn, std::size_t corner) {
  const auto holds = [corner](const CreaseRun& run) { return run.begin < corner && corner < run.end; };
  if (drawn.is_closed_up && std::any_of(drawn.runs.begin(), drawn.runs.end(), holds)) return false;
  return drawn.scale > 0.0 && (drawn.is_fine.empty() || drawn.is_fine[corner] == 0);
}

bool OutlineArcs::canRefine(int arc, std::size_t corner) const {
  const DrawnArc& drawn = drawn_[static_cast<std::size_t>(arc)];
  const auto reaches = [corner](const CreaseRun& run) { return run.begin <= corner && corner <= run.end; };
  return isSimplifiedAt(drawn, corner) ||
         (drawn.is_closed_up && std::any_of(drawn.runs.begin(), drawn.runs.end(), reaches));
}

void OutlineArcs::refineArea(int arc) {
  DrawnArc& drawn = drawn_[static_cast<std::size_t>(arc)];
  is_dirty_[static_cast<std::size_t>(arc)] = 1;
  if (drawn.is_bent) drawn.scale = drawn.scale > kLeastScale ? 0.5 * drawn.scale : 0.0;
  drawn.is_bent = true;
}

void OutlineArcs::release(int arc) {
  DrawnArc& drawn = drawn_[static_cast<std::size_t>(arc)];
  is_dirty_[static_cast<std::size_t>(arc)] = 1;
  drawn.is_closed_up = false;
  drawn.scale = 0.0;
}

bool OutlineArcs::canRefine(int arc) const {
  const DrawnArc& drawn = drawn_[static_cast<std::size_t>(arc)];
  return drawn.scale > 0.0 || (drawn.is_closed_up && !drawn.runs.empty());
}

std::vector<int> OutlineArcs::draw() {
  std::vector<int> changed;
  settleJunctions(changed);
  for (std::size_t i = 0; i < drawn_.size(); ++i) {
    if (is_dirty_[i] == 0) continue;
    drawArc(static_cast<int>(i));
    is_dirty_[i] = 0;
    for (const int label : {arcs_.arcs[i].left, arcs_.arcs[i].right})
      if (label > 0) changed.push_back(label);
  }
  return changed;
}

Eigen::Vector3d OutlineArcs::vertexPoint(int label, int arc, const DrawnArc::Vertex& vertex) const {
  const int corner = arcs_.arcs[static_cast<std::size_t>(arc)].corners[vertex.corner];
  if (const Junction* shared = junction(corner, label)) return shared->point;
  if (vertex.shared) return *vertex.shared;
  return planes_.corner(label, arcs_.row(corner), arcs_.column(corner), vertex.shift);
}

void OutlineArcs::drawArc(int arc) {
  DrawnArc& drawn = drawn_[static_cast<std::size_t>(arc)];
  const std::vector<int>& corners = arcs_.arcs[static_cast<std::size_t>(arc)].corners;
  drawn.change[0] = drawn.change[1] = 0.0;
  drawn.vertices.assign(1, {0, Eigen::Vector2d::Zero(), std::nullopt});
  std::size_t begin = 0;
  if (drawn.is_closed_up) {
    for (const CreaseRun& run : drawn.runs) {
      drawStretch(arc, begin, run.begin);
      drawn.vertices.back().shared = run.first;
      drawn.vertices.push_back({run.end, Eigen::Vector2d::Zero(), run.last});
      begin = run.end;
    }
  }
  drawStretch(arc, begin, corners.size() - 1);
  if (corners.front() != corners.back()) return;
  DrawnArc::Vertex &first = drawn.vertices.front(), &last = drawn.vertices.back();  // are one
  if (first.shared)
    last.shared = first.shared;
  else
    first.shared = last.shared;
}

/// Adds the vertices between two corners that stay where they are, and the second of them.
void OutlineArcs::drawStretch(int arc, std::size_t begin, std::size_t end) {
  if (begin == end) return;
  DrawnArc& drawn = drawn_[static_cast<std::size_t>(arc)];
  const std::vector<int>& corners = arcs_.arcs[static_cast<std::size_t>(arc)].corners;
  const std::size_t first_vertex = drawn.vertices.size() - 1;
  std::vector<std::size_t> kept = simplify(arc, begin, end);
  // All corners between two that stay lie to one side of their line: only a bend can balance it.
  if (drawn.is_bent && kept.size() == 2 && end - begin >= kLeastBent) kept.insert(kept.begin() + 1, (begin + end) / 2);
  std::vector<Eigen::Vector2d> places;
  for (std::size_t i = begin; i <= end; ++i) places.push_back(pixelPlace(corners[begin], corners[i]));
  const bool is_whole = begin == 0 && end + 1 == corners.size() && corners.front() == corners.back();
  const std::vector<Eigen::Vector2d> shifts = balancedShifts(places, kept, begin, is_whole);
  drawn.vertices.back().shift = shifts.front();
  for (std::size_t i = 1; i < kept.size(); ++i) drawn.vertices.push_back({kept[i], shifts[i], std::nullopt});
  measureChange(arc, begin, end, first_vertex);
}

/// The area between the corners and the vertices drawn for them.
void OutlineArcs::measureChange(int arc, std::size_t begin, std::size_t end, std::size_t first_vertex) {
  DrawnArc& drawn = drawn_[static_cast<std::size_t>(arc)];
  const LabelArc& own = arcs_.arcs[static_cast<std::size_t>(arc)];
  for (int side = 0; side < 2; ++side) {
    const std::vector<Vector2>& flat = drawn.flat[side];
    if (flat.empty()) continue;
    const int label = side == 0 ? own.left : own.right;
    const Eigen::Vector2d origin = flat[begin];
    double twice = 0.0;
    for (std::size_t i = begin; i < end; ++i) twice -= cross(flat[i] - origin, flat[i + 1] - origin);
    Eigen::Vector2d before = Eigen::Vector2d::Zero();
    for (std::size_t i = first_vertex; i < drawn.vertices.size(); ++i) {
      const DrawnArc::Vertex& vertex = drawn.vertices[i];
      const int corner = own.corners[vertex.corner];
      Eigen::Vector2d place = flat[vertex.corner];
      if (!vertex.shift.isZero())
        place = planes_.flat(label, planes_.corner(label, arcs_.row(corner), arcs_.column(corner), vertex.shift));
      place -= origin;
      if (i > first_vertex) twice += cross(before, place);
      before = place;
    }
    drawn.change[side] += 0.5 * twice;
  }
}

double OutlineArcs::cornersArea(int arc, int side) const {
  double sum = 0.0;
  const std::vector<Vector2>& flat = drawn(arc).flat[side];
  for (std::size_t i = 1; i < flat.size(); ++i) sum += cross(flat[i - 1], flat[i]);
  return 0.5 * sum;
}

}  // namespace epcc
