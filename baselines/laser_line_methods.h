// SPDX-License-Identifier: BSD-3-Clause
// Other methods for the lines of a laser scan, to compare with.
#pragma once

#include <cstdint>
#include <vector>

#include "epcc_segmentation/laser_scan.h"

namespace epcc {

/// What all of them are told.
struct LaserMethodParameters {
  double distance = 0.03;  ///< of a point from its line at most, metres
  double max_gap = 0.3;    ///< between neighbours on a line, metres; at a distance three steps of the beams
  int min_points = 8;
  int iterations = 500;  ///< of RANSAC, for one line
};

/// A line by the beams on it; alpha and rho are those of total least squares.
struct MethodLine {
  std::vector<int> beams;
  double alpha = 0.0, rho = 0.0;
};

/// Split-and-Merge as in Nguyen, Gächter, Martinelli, Tomatis, Siegwart, "A comparison of line extraction algorithms
/// using 2D range data for indoor mobile robotics", Autonomous Robots 23, 2007: clusters between jumps are fitted and
/// split at the farthest point until all are near, then neighbours that are one line are merged.
std::vector<MethodLine> splitAndMergeLines(const LaserScan& scan, const LaserMethodParameters& parameters);

/// PCL's RANSAC for SACMODEL_LINE on the points, again and again on those left. Inliers are parted at gaps; without
/// that a line would go through all rooms.
std::vector<MethodLine> ransacLines(const LaserScan& scan, const LaserMethodParameters& parameters);

/// Labels of the beams as in LaserLines.
std::vector<std::int32_t> beamLabels(const LaserScan& scan, const std::vector<MethodLine>& lines);

}  // namespace epcc
