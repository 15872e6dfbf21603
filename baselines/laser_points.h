// SPDX-License-Identifier: BSD-3-Clause
// What the methods for laser scans share.
#pragma once

#include <vector>

#include "baselines/laser_line_methods.h"

namespace epcc {

struct LaserPoint {
  Vector2 at;
  int beam;
};

/// Points of the beams with a return, in their order.
std::vector<LaserPoint> laserPoints(const LaserScan& scan);

/// Whether two points, neighbours among those of a line, are too far apart for it.
bool isJump(const LaserScan& scan, const LaserPoint& a, const LaserPoint& b, double max_gap);

/// Total least squares of points [first, last); without their beams.
MethodLine fitMethodLine(const std::vector<LaserPoint>& points, std::size_t first, std::size_t last);

/// The same with the beams.
MethodLine finishedLine(const std::vector<LaserPoint>& points, std::size_t first, std::size_t last);

double distanceFrom(const MethodLine& line, const LaserPoint& point);

}  // namespace epcc
