// SPDX-License-Identifier: BSD-3-Clause
// Scans of points, and whether a scan goes round.
#include "epcc_segmentation/laser_scan.h"

#include <cmath>

namespace epcc {

LaserScan LaserScan::fromPoints(const std::vector<Vector2>& points) {
  LaserScan scan;
  scan.ranges.reserve(points.size());
  scan.angles.reserve(points.size());
  double last = 0.0;
  for (const Vector2& point : points) {
    const bool finite = std::isfinite(point.x()) && std::isfinite(point.y());
    if (finite) {
      // Of the angles that differ by whole turns the one next to the last, so that a full circle is known as one.
      const double angle = std::atan2(point.y(), point.x());
      last = scan.angles.empty() ? angle : last + std::remainder(angle - last, 2.0 * std::acos(-1.0));
    }
    scan.ranges.push_back(finite ? std::hypot(point.x(), point.y()) : std::nan(""));
    scan.angles.push_back(last);
  }
  return scan;
}

bool LaserScan::isFullCircle() const {
  if (ranges.size() < 3) return false;
  const double turn = 2.0 * std::acos(-1.0);
  const double span = std::abs(angle(ranges.size() - 1) - angle(0));
  const double step = span / static_cast<double>(ranges.size() - 1);
  return span > turn - 2.5 * step && span < turn + 0.5 * step;
}

}  // namespace epcc
