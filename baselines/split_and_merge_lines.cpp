// SPDX-License-Identifier: BSD-3-Clause
// Split-and-Merge, the classical method for lines of laser scans.
#include <algorithm>

#include "baselines/laser_points.h"

namespace epcc {
namespace {

struct Part {
  std::size_t first, last;  // [first, last)
};

/// The farthest point of a part, and whether it is too far.
bool farthestPoint(const std::vector<LaserPoint>& points, Part part, double most, std::size_t& farthest) {
  const MethodLine line = fitMethodLine(points, part.first, part.last);
  double largest = 0.0;
  for (std::size_t i = part.first; i < part.last; ++i) {
    const double distance = distanceFrom(line, points[i]);
    if (distance <= largest) continue;
    largest = distance;
    farthest = i;
  }
  return largest > most;
}

/// Parts of one cluster, in order. Depth first, so that they come in order without recursion.
void split(const std::vector<LaserPoint>& points, Part cluster, double most, std::vector<Part>& parts) {
  std::vector<Part> open{cluster};
  while (!open.empty()) {
    const Part part = open.back();
    open.pop_back();
    std::size_t farthest = part.first;
    if (part.last - part.first < 3 || !farthestPoint(points, part, most, farthest)) {
      parts.push_back(part);
      continue;
    }
    // An end cannot part a set: then its neighbour does.
    farthest = std::clamp(farthest, part.first + 1, part.last - 1);
    open.push_back({farthest, part.last});
    open.push_back({part.first, farthest});
  }
}

void merge(const std::vector<LaserPoint>& points, double most, std::vector<Part>& parts) {
  for (std::size_t i = 0; i + 1 < parts.size();) {
    const Part both{parts[i].first, parts[i + 1].last};
    std::size_t ignored = 0;
    if (farthestPoint(points, both, most, ignored)) {
      ++i;
      continue;
    }
    parts[i] = both;
    parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(i) + 1);
    if (i > 0) --i;
  }
}

}  // namespace

std::vector<MethodLine> splitAndMergeLines(const LaserScan& scan, const LaserMethodParameters& parameters) {
  const std::vector<LaserPoint> points = laserPoints(scan);
  std::vector<MethodLine> lines;
  for (std::size_t first = 0; first < points.size();) {
    std::size_t last = first + 1;
    while (last < points.size() && !isJump(scan, points[last - 1], points[last], parameters.max_gap)) ++last;
    std::vector<Part> parts;
    split(points, {first, last}, parameters.distance, parts);
    merge(points, parameters.distance, parts);
    for (const Part& part : parts)
      if (part.last - part.first >= static_cast<std::size_t>(parameters.min_points))
        lines.push_back(finishedLine(points, part.first, part.last));
    first = last;
  }
  return lines;
}

}  // namespace epcc
