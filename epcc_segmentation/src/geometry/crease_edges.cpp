// SPDX-License-Identifier: BSD-3-Clause
// Sums up along the runs, and joins runs of one pair of planes that nearly touch.
#include "geometry/crease_edges.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace epcc {

namespace {

/// A part of the line of two planes.
struct Part {
  double from = 0.0, to = 0.0;  // along the line, metres
  Eigen::Vector3d start, end;   // scan frame
  int pixels = 0;
  double squares = 0.0;  // of the offsets
  double nearer = 0.0;   // on the first plane's side: by how much that is in front of the other, pixels

  double metresPerPixel() const { return (to - from) / std::max(1, pixels); }
};

/// One side of a pixel on the border: where its middle is, and the centres of the pixels beside it.
Part partOf(const PlaneCrease& crease, const LabelArcs& arcs, const LabelArc& arc, const CreaseRun& run) {
  Part part;
  part.start = run.first;
  part.end = run.last;
  const bool first_is_left = arc.left < arc.right;
  for (std::size_t i = run.begin; i < run.end; ++i) {
    const int a = arc.corners[i], b = arc.corners[i + 1];
    int columns = arcs.column(b) - arcs.column(a);
    if (std::abs(columns) > 1) columns = columns > 0 ? -1 : 1;  // across the seam of a scan
    const int rows = arcs.row(b) - arcs.row(a);
    const double column = arcs.column(a) - 0.5 + 0.5 * columns, row = arcs.row(a) - 0.5 + 0.5 * rows;
    // To the left of a step to the right is what is above it.
    const double to_first = first_is_left ? 0.5 : -0.5;
    const double nearer = crease.offset(column + to_first * rows, row - to_first * columns);
    part.nearer += nearer - crease.offset(column - to_first * rows, row + to_first * columns);
    const double offset = crease.offset(column, row);
    part.squares += offset * offset;
    ++part.pixels;
  }
  part.from = crease.along(part.start);
  part.to = crease.along(part.end);
  // `first` to the left of the way from start to end.
  if (!first_is_left) std::swap(part.start, part.end);
  if (part.from > part.to) std::swap(part.from, part.to);
  return part;
}

void join(Part& part, const Part& next, const PlaneCrease& crease) {
  const bool is_upwards = crease.along(part.start) <= crease.along(part.end);
  const auto farther = [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return crease.along(a) > crease.along(b) ? a : b;
  };
  const auto nearer = [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return crease.along(a) > crease.along(b) ? b : a;
  };
  const Eigen::Vector3d low = nearer(nearer(part.start, part.end), nearer(next.start, next.end));
  const Eigen::Vector3d high = farther(farther(part.start, part.end), farther(next.start, next.end));
  part.start = is_upwards ? low : high;
  part.end = is_upwards ? high : low;
  part.to = std::max(part.to, next.to);
  part.pixels += next.pixels;
  part.squares += next.squares;
  part.nearer += next.nearer;
}

std::vector<Part> joined(std::vector<Part> parts, const PlaneCrease& crease, int max_gap) {
  std::sort(parts.begin(), parts.end(), [](const Part& a, const Part& b) { return a.from < b.from; });
  std::vector<Part> all;
  for (const Part& part : parts) {
    const double reach =
        all.empty() ? 0.0 : (max_gap + 1) * std::max(part.metresPerPixel(), all.back().metresPerPixel());
    if (!all.empty() && part.from <= all.back().to + reach)
      join(all.back(), part, crease);
    else
      all.push_back(part);
  }
  return all;
}

}  // namespace

std::vector<PlaneEdge> creaseEdges(const PixelRays& rays, const EdgeOptions& options, const OutlineArcs& outlines,
                                   PlaneCreases& creases) {
  std::map<std::pair<int, int>, std::vector<Part>> parts;
  const LabelArcs& arcs = outlines.arcs();
  for (std::size_t i = 0; i < arcs.arcs.size(); ++i) {
    const LabelArc& arc = arcs.arcs[i];
    const std::pair<int, int> pair = std::minmax(arc.left, arc.right);
    for (const CreaseRun& run : outlines.drawn(static_cast<int>(i)).runs)
      parts[pair].push_back(partOf(*creases.find(pair.first, pair.second), arcs, arc, run));
  }
  std::vector<PlaneEdge> edges;
  for (const auto& [pair, of_pair] : parts) {
    const PlaneCrease& crease = *creases.find(pair.first, pair.second);
    for (const Part& part : joined(of_pair, crease, options.max_gap)) {
      PlaneEdge edge;
      edge.first = pair.first;
      edge.second = pair.second;
      edge.start = rays.toCaller(part.start);
      edge.end = rays.toCaller(part.end);
      edge.length = (edge.end - edge.start).norm();
      if (!(edge.length > 0.0)) continue;  // both ends are one point of three planes
      edge.angle = crease.angle();
      edge.convex = part.nearer < 0.0;
      edge.pixels = part.pixels;
      edge.offset = std::sqrt(part.squares / std::max(1, part.pixels));
      edges.push_back(edge);
    }
  }
  return edges;
}

}  // namespace epcc
