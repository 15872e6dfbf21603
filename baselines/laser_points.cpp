// SPDX-License-Identifier: BSD-3-Clause
// Points of scans and lines through them.
#include "baselines/laser_points.h"

#include <algorithm>
#include <cmath>

namespace epcc {

std::vector<LaserPoint> laserPoints(const LaserScan& scan) {
  std::vector<LaserPoint> points;
  for (std::size_t i = 0; i < scan.ranges.size(); ++i)
    if (scan.hasReturn(i))
      points.push_back(
          {scan.ranges[i] * Vector2(std::cos(scan.angle(i)), std::sin(scan.angle(i))), static_cast<int>(i)});
  return points;
}

bool isJump(const LaserScan& scan, const LaserPoint& a, const LaserPoint& b, double max_gap) {
  const double step = 3.0 * std::abs(scan.angle_increment) * std::max(a.at.norm(), b.at.norm());
  return (a.at - b.at).norm() > std::max(max_gap, step);
}

MethodLine fitMethodLine(const std::vector<LaserPoint>& points, std::size_t first, std::size_t last) {
  MethodLine line;
  Vector2 mean = Vector2::Zero();
  for (std::size_t i = first; i < last; ++i) mean += points[i].at;
  mean /= static_cast<double>(last - first);
  double xx = 0.0, xy = 0.0, yy = 0.0;
  for (std::size_t i = first; i < last; ++i) {
    const Vector2 d = points[i].at - mean;
    xx += d.x() * d.x();
    xy += d.x() * d.y();
    yy += d.y() * d.y();
  }
  const double along = 0.5 * std::atan2(2.0 * xy, xx - yy);
  Vector2 normal(-std::sin(along), std::cos(along));
  if (normal.dot(mean) < 0.0) normal = -normal;
  line.alpha = std::atan2(normal.y(), normal.x());
  line.rho = normal.dot(mean);
  return line;
}

MethodLine finishedLine(const std::vector<LaserPoint>& points, std::size_t first, std::size_t last) {
  MethodLine line = fitMethodLine(points, first, last);
  for (std::size_t i = first; i < last; ++i) line.beams.push_back(points[i].beam);
  return line;
}

double distanceFrom(const MethodLine& line, const LaserPoint& point) {
  return std::abs(std::cos(line.alpha) * point.at.x() + std::sin(line.alpha) * point.at.y() - line.rho);
}

std::vector<std::int32_t> beamLabels(const LaserScan& scan, const std::vector<MethodLine>& lines) {
  std::vector<std::int32_t> labels(scan.ranges.size(), 0);
  for (std::size_t k = 0; k < lines.size(); ++k)
    for (const int beam : lines[k].beams) labels[static_cast<std::size_t>(beam)] = static_cast<std::int32_t>(k + 1);
  return labels;
}

}  // namespace epcc
