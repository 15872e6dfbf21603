// SPDX-License-Identifier: BSD-3-Clause
// S1 to S3 per scan direction, then the steps on the joint regions.
#include "inverse_depth/inverse_depth_pipeline.h"

#include <algorithm>
#include <cmath>
#include <numeric>

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
  image_.read(frame);
  image_.weigh(sensor_);
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
  const float* weight = columns ? image_.weight_transposed.data() : image_.weight.data();
  const double* x = columns ? image_.along.data() : image_.across.data();
  direction.lines.clear();
  direction.line_begin.assign(1, 0);
  direction.segment_of.resize(static_cast<std::size_t>(scan_lines) * length);
  for (int i = 0; i < scan_lines; ++i) {
    const std::size_t start = static_cast<std::size_t>(i) * length;
    line_growing_.grow(w + start, weight + start, x, length, static_cast<std::int32_t>(direction.lines.size()),
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

// S3: a pixel takes the larger of its two planes; row planes are numbered after the column planes.
void InverseDepthPipeline::joinDirections() {
  constexpr int kBlock = 32;  // the columns' pixels lie transposed: block by block they stay in the cache
  rankPlanes();
  map_.labels.resize(image_.w.size());
  for (int row_block = 0; row_block < image_.height; row_block += kBlock)
    for (int column_block = 0; column_block < image_.width; column_block += kBlock)
      joinBlock(row_block, std::min(row_block + kBlock, image_.height), column_block,
                std::min(column_block + kBlock, image_.width));
  map_.regions.assign(label_of_rank_.size() - 1, PlaneMoments());
  map_.accumulate(image_);
}

// Planes of both directions by size, largest first; of equal ones those of the columns come first. Planes that are
// too small have the last rank, label 0.
void InverseDepthPipeline::rankPlanes() {
  std::vector<double> points;
  for (const Direction* direction : {&by_columns_, &by_rows_})
    if (direction->active) points.insert(points.end(), direction->plane_points.begin(), direction->plane_points.end());
  label_of_rank_.resize(points.size());
  std::iota(label_of_rank_.begin(), label_of_rank_.end(), 1);
  std::stable_sort(label_of_rank_.begin(), label_of_rank_.end(), [&](std::int32_t a, std::int32_t b) {
    return points[static_cast<std::size_t>(a - 1)] > points[static_cast<std::size_t>(b - 1)];
  });
  const auto none = static_cast<std::int32_t>(points.size());
  std::vector<std::int32_t> rank_of_label(points.size() + 1, none);
  for (std::int32_t rank = 0; rank < none; ++rank) {
    const std::int32_t label = label_of_rank_[static_cast<std::size_t>(rank)];
    if (points[static_cast<std::size_t>(label - 1)] > 0.0) rank_of_label[static_cast<std::size_t>(label)] = rank;
  }
  label_of_rank_.push_back(0);

  std::size_t first_label = 1;
  for (Direction* direction : {&by_columns_, &by_rows_}) {
    // Entry 0 is for pixels of no segment.
    direction->rank_of.assign(1, none);
    if (!direction->active) continue;
    for (const int plane : direction->plane_of)
      direction->rank_of.push_back(rank_of_label[first_label + static_cast<std::size_t>(plane)]);
    first_label += direction->plane_points.size();
  }
}

void InverseDepthPipeline::joinBlock(int row_begin, int row_end, int column_begin, int column_end) {
  const auto width = static_cast<std::size_t>(image_.width);
  const auto height = static_cast<std::size_t>(image_.height);
  const std::int32_t* column_segment = by_columns_.active ? by_columns_.segment_of.data() : nullptr;
  const std::int32_t* row_segment = by_rows_.active ? by_rows_.segment_of.data() : nullptr;
  for (auto row = static_cast<std::size_t>(row_begin); row < static_cast<std::size_t>(row_end); ++row)
    for (auto column = static_cast<std::size_t>(column_begin); column < static_cast<std::size_t>(column_end);
         ++column) {
      const std::size_t pixel = row * width + column;
      const std::int32_t c = column_segment != nullptr ? column_segment[column * height + row] : -1;
      const std::int32_t r = row_segment != nullptr ? row_segment[pixel] : -1;
      const std::int32_t rank = std::min(by_columns_.rank_of[static_cast<std::size_t>(c + 1)],
                                         by_rows_.rank_of[static_cast<std::size_t>(r + 1)]);
      map_.labels[pixel] = label_of_rank_[static_cast<std::size_t>(rank)];
    }
}

void InverseDepthPipeline::mergeRegions() {
  const double blotch = parameters_.merging.bridge_samples * sensor_.pixelsPerLineSample();
  const int bridge = std::max(parameters_.merging.min_bridge_pixels, static_cast<int>(blotch));
  epcc::mergeRegions(findContacts(image_, bridge, parameters_.refinement.max_residual, map_), parameters_.merging,
                     sensor_, map_);
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
