// SPDX-License-Identifier: BSD-3-Clause
// S1 to S3 per scan direction, then the steps on the joint regions.
#include "inverse_depth/inverse_depth_pipeline.h"

#include <algorithm>
#include <cmath>

#include "inverse_depth/boundary_refinement.h"
#include "inverse_depth/evidence.h"
#include "inverse_depth/region_merging.h"

namespace epcc {

InverseDepthPipeline::InverseDepthPipeline(const Parameters& parameters, const SensorModel& sensor)
    : parameters_(parameters),
      sensor_(sensor),
      line_growing_(parameters.line_growing),
      plane_growing_(parameters.plane_growing, sensor) {}

void InverseDepthPipeline::read(const DepthFrame& frame) {
  image_.read(frame, sensor_);
  by_columns_.active = parameters_.scan != ScanDirection::Rows;
  by_rows_.active = parameters_.scan != ScanDirection::Columns && image_.planar_rows;
}

void InverseDepthPipeline::growLines() {
  if (by_columns_.active) growLines(true, by_columns_);
  if (by_rows_.active) growLines(false, by_rows_);
}

void InverseDepthPipeline::growPlanes() {
  if (by_columns_.active) growPlanes(true, by_columns_);
  if (by_rows_.active) growPlanes(false, by_rows_);
}

void InverseDepthPipeline::growLines(bool columns, Direction& direction) {
  const int scan_lines = columns ? image_.width : image_.height;
  const int length = columns ? image_.height : image_.width;
  const float* w = columns ? image_.w_transposed.data() : image_.w.data();
  const double* x = columns ? image_.along.data() : image_.across.data();
  const double* scale = columns && !image_.planar_rows ? image_.measured_scale.data() : nullptr;
  direction.lines.clear();
  direction.line_begin.assign(1, 0);
  direction.segment_of.resize(static_cast<std::size_t>(scan_lines) * length);
  for (int i = 0; i < scan_lines; ++i) {
    const std::size_t start = static_cast<std::size_t>(i) * length;
    line_growing_.grow(w + start, x, scale, length, image_.noise, static_cast<std::int32_t>(direction.lines.size()),
                       direction.lines, direction.segment_of.data() + start);
    direction.line_begin.push_back(direction.lines.size());
  }
}

void InverseDepthPipeline::growPlanes(bool columns, Direction& direction) {
  plane_growing_.begin(pixelPitch(columns ? image_.along : image_.across));
  for (std::size_t i = 0; i + 1 < direction.line_begin.size(); ++i) {
    ScanLineRays rays;
    if (columns)
      rays = {{image_.across[i], 0.0, image_.forward[i]}, Eigen::Vector3d::UnitY()};
    else
      rays = {{0.0, image_.along[i], 1.0}, Eigen::Vector3d::UnitX()};
    plane_growing_.addLine(rays, direction.lines.data() + direction.line_begin[i],
                           direction.line_begin[i + 1] - direction.line_begin[i]);
  }
  direction.plane_of = plane_growing_.planeOf();
  direction.plane_points.clear();
  for (const GrownPlane& plane : plane_growing_.planes())
    direction.plane_points.push_back(plane.moments.n >= parameters_.plane_growing.min_points &&
                                             plane.segments >= parameters_.plane_growing.min_segments
                                         ? plane.moments.n
                                         : 0.0);
}

double InverseDepthPipeline::pixelPitch(const std::vector<double>& coordinate) const {
  double low = 0.0, high = 0.0;
  for (const double x : coordinate) low = std::min(low, x), high = std::max(high, x);
  return coordinate.size() > 1 ? (high - low) / static_cast<double>(coordinate.size() - 1) : 0.0;
}

// S3: a pixel takes the larger of its two planes; row planes are numbered after the column planes.
void InverseDepthPipeline::joinDirections() {
  const std::size_t width = static_cast<std::size_t>(image_.width);
  const std::size_t height = static_cast<std::size_t>(image_.height);
  const auto plane_at = [](const Direction& direction, std::size_t at, double& points) -> std::int32_t {
    const std::int32_t segment = direction.active ? direction.segment_of[at] : -1;
    if (segment < 0) return -1;
    const int plane = direction.plane_of[static_cast<std::size_t>(segment)];
    points = direction.plane_points[static_cast<std::size_t>(plane)];
    return points > 0.0 ? plane : -1;
  };
  const auto column_planes = static_cast<std::int32_t>(by_columns_.active ? by_columns_.plane_points.size() : 0);
  const auto row_planes = static_cast<std::int32_t>(by_rows_.active ? by_rows_.plane_points.size() : 0);
  map_.labels.assign(width * height, 0);
  for (std::size_t row = 0; row < height; ++row)
    for (std::size_t column = 0; column < width; ++column) {
      double points_c = 0.0, points_r = 0.0;
      const std::int32_t c = plane_at(by_columns_, column * height + row, points_c);
      const std::int32_t r = plane_at(by_rows_, row * width + column, points_r);
      if (c >= 0 && (r < 0 || points_c >= points_r))
        map_.labels[row * width + column] = c + 1;
      else if (r >= 0)
        map_.labels[row * width + column] = column_planes + r + 1;
    }
  map_.regions.assign(static_cast<std::size_t>(column_planes + row_planes), PlaneMoments());
  map_.accumulate(image_);
}

void InverseDepthPipeline::mergeRegions() {
  const int bridge = static_cast<int>(parameters_.merging.bridge_samples * sensor_.pixelsPerLineSample());
  epcc::mergeRegions(findContacts(image_, bridge, map_), parameters_.merging, sensor_, map_);
  dropSmallRegions(parameters_.merging, sensor_, map_);
}

void InverseDepthPipeline::refineBoundaries() {
  epcc::refineBoundaries(image_, parameters_.refinement, map_);
  map_.accumulate(image_);
  mergeRegions();  // S6
}

void InverseDepthPipeline::rejectClutter() {
  rejectRegions(image_, parameters_.evidence, sensor_, map_);
}

void InverseDepthPipeline::joinOccluded() {
  const RegionContacts contacts =
      findOccludedContacts(image_, parameters_.merging.max_occluder, parameters_.refinement.max_residual, map_);
  epcc::mergeRegions(contacts, parameters_.merging, sensor_, map_);
}

}  // namespace epcc
