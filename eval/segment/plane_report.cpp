// SPDX-License-Identifier: BSD-3-Clause
// Measures planes for the report and prints the table.
#include "eval/segment/plane_report.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>

namespace epcc {
namespace {

constexpr double kDegrees = 180.0 / M_PI;
constexpr double kLying = 30.0;     // degrees of tilt below which a plane lies
constexpr double kStanding = 60.0;  // and above which it stands

struct CellSum {
  double area = 0.0;
  std::size_t cells = 0;
};

// Area between a pixel and its right and lower neighbours on the same plane, seen along the normal.
void addCell(const DepthFrame& frame, const PlaneSegmentation& result, int row, int column,
             std::vector<CellSum>& sums) {
  const auto label = [&](int r, int c) { return result.labels[frame.index(r, c)]; };
  const std::int32_t id = label(row, column);
  if (id <= 0 || label(row, column + 1) != id || label(row + 1, column) != id) return;
  Eigen::Vector3d corner, right, below;
  if (!frame.point(row, column, corner) || !frame.point(row, column + 1, right) || !frame.point(row + 1, column, below))
    return;
  const Plane& plane = result.planes[static_cast<std::size_t>(id - 1)];
  const Eigen::Vector3d normal = plane.coefficients.head<3>();
  CellSum& sum = sums[static_cast<std::size_t>(id - 1)];
  sum.area += normal.dot((right - corner).cross(below - corner));
  ++sum.cells;
}

// Mean cell times pixel count: pixels at holes and borders count like the others.
std::vector<double> visibleAreas(const DepthFrame& frame, const PlaneSegmentation& result) {
  std::vector<CellSum> sums(result.planes.size());
  for (int row = 0; row + 1 < frame.height(); ++row) {
    for (int column = 0; column + 1 < frame.width(); ++column) addCell(frame, result, row, column, sums);
  }
  std::vector<double> areas;
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const double mean = sums[i].cells > 0 ? std::abs(sums[i].area) / static_cast<double>(sums[i].cells) : 0.0;
    areas.push_back(mean * static_cast<double>(result.planes[i].pixel_count));
  }
  return areas;
}

// Share of the unit normal that points up for the sensor: y is down in the scan frame.
double upward(const DepthFrame& frame, const Plane& plane) {
  const Eigen::Vector3d up = frame.fromScan(-Eigen::Vector3d::UnitY()) - frame.fromScan(Eigen::Vector3d::Zero());
  return std::clamp(up.dot(plane.coefficients.head<3>()), -1.0, 1.0);
}

std::string kindOf(double tilt, double up) {
  if (tilt >= kStanding) return "wall-like";
  if (tilt > kLying) return "slanted";
  return up > 0.0 ? "floor-like" : "ceiling-like";
}

}  // namespace

std::vector<PlaneSummary> summarizePlanes(const DepthFrame& frame, const PlaneSegmentation& result) {
  const std::vector<double> areas = visibleAreas(frame, result);
  const Eigen::Vector3d sensor = frame.fromScan(Eigen::Vector3d::Zero());
  std::vector<PlaneSummary> summaries;
  for (std::size_t i = 0; i < result.planes.size(); ++i) {
    const Plane& plane = result.planes[i];
    const double up = upward(frame, plane);
    PlaneSummary summary;
    summary.id = static_cast<int>(i) + 1;
    summary.pixels = plane.pixel_count;
    summary.area = areas[i];
    summary.distance = std::abs(plane.signedDistance(sensor));
    summary.centroid_distance = (plane.centroid - sensor).norm();
    summary.tilt = std::acos(std::abs(up)) * kDegrees;
    summary.kind = kindOf(summary.tilt, up);
    summary.rms = plane.rms;
    summary.confidence = plane.confidence;
    summaries.push_back(summary);
  }
  return summaries;
}

std::string planeTable(const std::vector<PlaneSummary>& planes, const std::string& indent) {
  std::string table =
      indent + "plane   pixels  area m2  distance m  centroid m  tilt deg  kind          rms mm  confidence\n";
  for (const PlaneSummary& plane : planes) {
    char line[160];
    std::snprintf(line, sizeof line, "%5d %8zu %8.3f %11.3f %11.3f %9.1f  %-12s %7.1f %11.2f\n", plane.id, plane.pixels,
                  plane.area, plane.distance, plane.centroid_distance, plane.tilt, plane.kind.c_str(), 1e3 * plane.rms,
                  plane.confidence);
    table += indent + line;
  }
  return table;
}

}  // namespace epcc
