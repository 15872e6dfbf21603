// SPDX-License-Identifier: BSD-3-Clause
// A scan stands upright as the one column of a scanner's cloud.
#include "eval/line_study/image_column_lines.h"

#include <cmath>

#include "epcc_segmentation/plane_extractor.h"

namespace epcc {
namespace {

constexpr double kWidest = 1.55;  // rad
constexpr double kNear = 3.0;     // sigma

/// x forward, z up: angles grow downwards, as the rows of an image do.
std::vector<float> columnOf(const LaserScan& scan) {
  std::vector<float> points;
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    const bool ahead = scan.hasReturn(i) && std::abs(scan.angle(i)) < kWidest;
    const double range = ahead ? scan.ranges[i] : std::nan("");
    points.push_back(static_cast<float>(range * std::cos(scan.angle(i))));
    points.push_back(0.0f);
    points.push_back(static_cast<float>(-range * std::sin(scan.angle(i))));
  }
  return points;
}

MethodLine lineOf(const LineSegment& segment, const LaserScan& scan, const SensorModel& noise) {
  const Vector2 start(segment.start.x(), -segment.start.z()), end(segment.end.x(), -segment.end.z());
  Vector2 normal(start.y() - end.y(), end.x() - start.x());
  normal.normalize();
  if (normal.dot(start) < 0.0) normal = -normal;
  MethodLine line;
  line.alpha = std::atan2(normal.y(), normal.x());
  line.rho = normal.dot(start);
  for (int beam = segment.first; beam <= segment.last; ++beam) {
    const auto i = static_cast<std::size_t>(beam);
    const double distance = scan.ranges[i] * std::cos(scan.angle(i) - line.alpha) - line.rho;
    if (scan.hasReturn(i) && std::abs(distance) < kNear * noise.sigmaZ(scan.ranges[i])) line.beams.push_back(beam);
  }
  return line;
}

}  // namespace

std::vector<MethodLine> imageColumnLines(const LaserScan& scan, const SensorModel& noise) {
  const std::vector<float> points = columnOf(scan);
  Parameters parameters = Parameters::forPaper();
  parameters.scan = ScanDirection::Columns;
  parameters.line_segments = true;
  PlaneExtractor extractor;
  extractor.setParameters(parameters);
  extractor.setSensor(noise);
  PlaneSegmentation result;
  std::vector<MethodLine> lines;
  const int height = static_cast<int>(scan.ranges.size());
  if (!extractor.extract(DepthFrame::fromPoints(points.data(), 3, 1, height, Projection::Spherical), result)) return {};
  for (const LineSegment& segment : result.segments) lines.push_back(lineOf(segment, scan, noise));
  return lines;
}

}  // namespace epcc
