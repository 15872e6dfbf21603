// SPDX-License-Identifier: BSD-3-Clause
// Which corners of an arc stay: the fewest whose lines are within the tolerance of all others.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "geometry/outline_arcs.h"

namespace epcc {

namespace {

constexpr double kLeastTolerance = 1e-6;  // pixels: corners on a straight line are left out in any case
constexpr double kMostNoise = 4.0;        // times tolerance_pixels

}  // namespace

/// Columns and rows from one corner to another.
Eigen::Vector2d OutlineArcs::pixelPlace(int from, int corner) const {
  return {static_cast<double>(columnsApart(from, corner)), static_cast<double>(arcs_.row(corner) - arcs_.row(from))};
}

double OutlineArcs::tolerance(const LabelArc& arc, int corner) const {
  const double column = place(corner, false), row = place(corner, true);
  const Eigen::Vector3d ray = rays_.ray(column, row);
  double w = 0.0;
  for (const int label : {arc.left, arc.right})
    if (label > 0 && planes_.exists(label)) w = std::max(w, planes_.q(label).dot(ray));
  if (!(w > 0.0)) return options_.tolerance_pixels;
  const double pixel = std::sqrt(rays_.pixelDeterminant(std::min(arcs_.column(corner), rays_.width() - 1),
                                                        std::min(arcs_.row(corner), rays_.height() - 1)));  // at w = 1
  const double noise = rays_.sigma(sensor_, ray, w) / (w * pixel);
  return std::min(kMostNoise * options_.tolerance_pixels, options_.tolerance_pixels + options_.tolerance_sigma * noise);
}

int OutlineArcs::columnsApart(int from, int to) const {
  int columns = arcs_.column(to) - arcs_.column(from);
  if (!rays_.closesRound()) return columns;
  if (2 * columns > arcs_.columns) columns -= arcs_.columns;
  if (2 * columns < -arcs_.columns) columns += arcs_.columns;
  return columns;
}

/// Pixels from a corner to the straight line in space, as it is seen, between two others: positive to one side of it.
/// Beyond its ends the distance to the nearer end, `is_beyond`.
double OutlineArcs::deviation(int from, int to, int corner, bool& is_beyond) const {
  const Eigen::Vector2d chord = pixelPlace(from, to), own = pixelPlace(from, corner);
  const double share = chord.squaredNorm() > 0.0 ? own.dot(chord) / chord.squaredNorm() : -1.0;
  is_beyond = share < 0.0 || share > 1.0;
  if (is_beyond) return share < 0.0 ? own.norm() : (own - chord).norm();
  const auto rayOf = [&](int c) { return rays_.ray(place(c, false), place(c, true)); };
  const Eigen::Vector3d normal = rayOf(from).cross(rayOf(to));
  const double column = place(corner, false), row = place(corner, true);
  const double slope = std::hypot(normal.dot(rays_.rayByColumn(column)), normal.dot(rays_.rayByRow(row)));
  return slope > 0.0 ? normal.dot(rays_.ray(column, row)) / slope : 0.0;
}

/// The corner farthest from the line between two others, if a line through the middle of all between them would leave
/// some beyond their tolerance; 0 if not.
std::size_t OutlineArcs::farthest(int arc, std::size_t from, std::size_t to) const {
  const LabelArc& own = arcs_.arcs[static_cast<std::size_t>(arc)];
  const DrawnArc& drawn = drawn_[static_cast<std::size_t>(arc)];
  double most = 0.0, least = 0.0, beyond = 0.0, worst = 0.0;  // in tolerances
  std::size_t at = 0;
  for (std::size_t i = from + 1; i < to; ++i) {
    bool is_beyond = false;
    const bool is_exact = !drawn.is_fine.empty() && drawn.is_fine[i] != 0;
    const double limit =
        is_exact ? kLeastTolerance : std::max(kLeastTolerance, drawn.scale * tolerance(own, own.corners[i]));
    const double share = deviation(own.corners[from], own.corners[to], own.corners[i], is_beyond) / limit;
    if (is_beyond) {
      beyond = std::max(beyond, share);
    } else {
      most = std::max(most, share);
      least = std::min(least, share);
    }
    if (std::abs(share) <= worst) continue;
    worst = std::abs(share);
    at = i;
  }
  return most - least > 2.0 || beyond > 1.0 ? at : 0;
}

/// After Douglas and Peucker (1973), for lines that are balanced afterwards: the corners that stay, both ends among
/// them.
std::vector<std::size_t> OutlineArcs::simplify(int arc, std::size_t begin, std::size_t end) const {
  std::vector<std::size_t> kept = {begin, end};
  std::vector<std::pair<std::size_t, std::size_t>> open = {{begin, end}};
  while (!open.empty()) {
    const auto [from, to] = open.back();
    open.pop_back();
    const std::size_t at = farthest(arc, from, to);
    if (at == 0) continue;
    kept.push_back(at);
    open.push_back({from, at});
    open.push_back({at, to});
  }
  std::sort(kept.begin(), kept.end());
  return kept;
}

}  // namespace epcc
