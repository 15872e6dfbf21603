// SPDX-License-Identifier: BSD-3-Clause
// Corners where common lines of planes end: whose line, or which point of three planes, all arcs there share.
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "geometry/outline_arcs.h"

namespace epcc {

namespace {

constexpr double kJunctionReach = 1.5;  // times max_offset: a point of three planes may be this far from the corner

}  // namespace

void OutlineArcs::settleJunctions(std::vector<int>& changed) {
  const std::map<int, Junction> before = std::move(junctions_);
  junctions_.clear();
  std::map<int, std::vector<Claim>> claims;
  for (std::size_t i = 0; i < drawn_.size(); ++i) {
    const std::vector<int>& corners = arcs_.arcs[i].corners;
    if (!drawn_[i].is_closed_up || corners.front() == corners.back()) continue;
    for (const CreaseRun& run : drawn_[i].runs) {
      const Claim claim{static_cast<int>(i), false, run.end - run.begin};
      if (run.begin == 0) claims[corners.front()].push_back(claim);
      if (run.end + 1 == corners.size()) claims[corners.back()].push_back({claim.arc, true, claim.length});
    }
  }
  for (auto& [corner, of_corner] : claims) settle(corner, of_corner);
  const auto compare = [&changed](const std::map<int, Junction>& all, const std::map<int, Junction>& others) {
    for (const auto& [corner, shared] : all) {
      const auto other = others.find(corner);
      if (other != others.end() && other->second.labels == shared.labels && other->second.point == shared.point)
        continue;
      changed.insert(changed.end(), shared.labels.begin(), shared.labels.end());
    }
  };
  compare(before, junctions_);
  compare(junctions_, before);
}

/// The longest run has its way; others join it if the point of all their planes is near.
void OutlineArcs::settle(int corner, std::vector<Claim>& claims) {
  std::sort(claims.begin(), claims.end(),
            [](const Claim& a, const Claim& b) { return a.length != b.length ? a.length > b.length : a.arc < b.arc; });
  Junction shared;
  const auto takes = [&](int label) {
    return std::find(shared.labels.begin(), shared.labels.end(), label) != shared.labels.end();
  };
  for (const Claim& claim : claims) {
    const LabelArc& arc = arcs_.arcs[static_cast<std::size_t>(claim.arc)];
    if (shared.labels.empty()) {
      const std::vector<CreaseRun>& runs = drawn_[static_cast<std::size_t>(claim.arc)].runs;
      shared.labels = {arc.left, arc.right};
      shared.point = claim.at_end ? runs.back().last : runs.front().first;
      continue;
    }
    if ((takes(arc.left) && takes(arc.right)) || shared.labels.size() > 2) continue;
    std::vector<int> labels = shared.labels;
    if (!takes(arc.left)) labels.push_back(arc.left);
    if (!takes(arc.right)) labels.push_back(arc.right);
    if (labels.size() != 3) continue;
    if (const auto point = commonPoint(labels, corner)) {
      shared.labels = labels;
      shared.point = *point;
    }
  }
  junctions_[corner] = shared;
  for (const Claim& claim : claims) {
    const LabelArc& arc = arcs_.arcs[static_cast<std::size_t>(claim.arc)];
    if (!takes(arc.left) || !takes(arc.right)) {
      trim(claim);
      continue;
    }
    std::vector<CreaseRun>& runs = drawn_[static_cast<std::size_t>(claim.arc)].runs;
    (claim.at_end ? runs.back().last : runs.front().first) = shared.point;
  }
}

/// The run ends a corner earlier.
void OutlineArcs::trim(const Claim& claim) {
  const PlaneCrease* line = crease(claim.arc);
  const std::vector<int>& corners = arcs_.arcs[static_cast<std::size_t>(claim.arc)].corners;
  std::vector<CreaseRun>& runs = drawn_[static_cast<std::size_t>(claim.arc)].runs;
  CreaseRun& run = claim.at_end ? runs.back() : runs.front();
  if (run.end < run.begin + 2) return;
  const std::size_t i = claim.at_end ? --run.end : ++run.begin;
  (claim.at_end ? run.last : run.first) = line->nearestPoint(place(corners[i], false), place(corners[i], true));
  is_dirty_[static_cast<std::size_t>(claim.arc)] = 1;
}

std::optional<Eigen::Vector3d> OutlineArcs::commonPoint(const std::vector<int>& labels, int corner) const {
  Eigen::Matrix3d equations;
  for (int k = 0; k < 3; ++k) equations.row(k) = planes_.q(labels[static_cast<std::size_t>(k)]).transpose();
  const Eigen::FullPivLU<Eigen::Matrix3d> solver(equations);
  if (!solver.isInvertible()) return std::nullopt;
  const Eigen::Vector3d point = solver.solve(Eigen::Vector3d::Ones());
  const double column = place(corner, false), row = place(corner, true);
  const Eigen::Vector3d ray = rays_.ray(column, row), by_column = rays_.rayByColumn(column),
                        by_row = rays_.rayByRow(row);
  // How far from the corner it is seen: the part of the ray that neither column nor row changes is the scale.
  const Eigen::Vector3d forward = by_column.cross(by_row);
  const double scale = forward.dot(point) / forward.dot(ray);
  if (!(scale > 0.0)) return std::nullopt;
  const Eigen::Vector3d off = point / scale - ray;
  const double pixels =
      std::hypot(off.dot(by_column) / by_column.squaredNorm(), off.dot(by_row) / by_row.squaredNorm());
  if (!(pixels <= kJunctionReach * options_.edges.max_offset)) return std::nullopt;
  return point;
}

const OutlineArcs::Junction* OutlineArcs::junction(int corner, int label) const {
  const auto found = junctions_.find(corner);
  if (found == junctions_.end()) return nullptr;
  const std::vector<int>& labels = found->second.labels;
  return std::find(labels.begin(), labels.end(), label) == labels.end() ? nullptr : &found->second;
}

}  // namespace epcc
