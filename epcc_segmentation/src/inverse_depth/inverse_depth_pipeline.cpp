// SPDX-License-Identifier: BSD-3-Clause
// S1 and S2 in each scan direction, then the steps on the joint regions.
#include "inverse_depth/inverse_depth_pipeline.h"

#include <algorithm>
#include <numeric>

#include "inverse_depth/boundary_refinement.h"
#include "inverse_depth/evidence.h"
#include "inverse_depth/region_merging.h"
#include "inverse_depth/sample_grid.h"
#include "inverse_depth/segment_records.h"
#include "inverse_depth/thickness.h"
#include "parallel_for.h"

namespace epcc {

InverseDepthPipeline::InverseDepthPipeline(const Parameters& parameters, const SensorModel& sensor)
    : parameters_(parameters),
      sensor_(sensor),
      grid_parameters_(parameters.inverse_depth),
      grid_sensor_(sensor),
      directions_{DirectionalPlanes(true, parameters.inverse_depth, sensor),
                  DirectionalPlanes(false, parameters.inverse_depth, sensor)} {}

void InverseDepthPipeline::configure(const Parameters& parameters, const SensorModel& sensor) {
  parameters_ = parameters;
  sensor_ = sensor;
}

void InverseDepthPipeline::begin(InverseDepthImage& image) {
  stride_ = strideFor(image.width, parameters_.inverse_depth.stride);
  grid_parameters_ = onGrid(parameters_.inverse_depth, stride_);
  grid_sensor_ = onGrid(sensor_, stride_);
  InverseDepthImage& grid = stride_ > 1 ? samples_ : image;
  if (stride_ > 1) grid.sample(image, stride_);
  grid.weigh(sensor_, image.placeVariance());
  full_image_ = &image;
  image_ = &grid;
  for (DirectionalPlanes& direction : directions_) direction.configure(grid_parameters_, grid_sensor_);
  directions_[0].setActive(parameters_.scan != ScanDirection::Rows);
  directions_[1].setActive(parameters_.scan != ScanDirection::Columns && image.planar_rows);
}

void InverseDepthPipeline::growLines() {
  inEachDirection(&DirectionalPlanes::growLines);
}

void InverseDepthPipeline::growPlanes() {
  inEachDirection(&DirectionalPlanes::growPlanes);
}

// The directions know nothing of each other until S3.
void InverseDepthPipeline::inEachDirection(void (DirectionalPlanes::*step)(const InverseDepthImage&)) {
  parallelFor(static_cast<int>(directions_.size()), parameters_.threads, [&](int /*thread*/, int begin, int end) {
    for (int k = begin; k < end; ++k) (directions_[static_cast<std::size_t>(k)].*step)(*image_);
  });
}

// S3: a pixel takes the larger of its two planes; row planes are numbered after the column planes.
void InverseDepthPipeline::joinDirections() {
  constexpr int kBlock = 32;  // the columns' pixels lie transposed: block by block they stay in the cache
  rankPlanes();
  map_.labels.resize(image_->w.size());
  const int blocks = (image_->height + kBlock - 1) / kBlock;
  parallelFor(blocks, parameters_.threads, [&](int /*thread*/, int begin, int end) {
    for (int row = begin * kBlock; row < std::min(end * kBlock, image_->height); row += kBlock)
      for (int column = 0; column < image_->width; column += kBlock)
        joinBlock(row, std::min(row + kBlock, image_->height), column, std::min(column + kBlock, image_->width));
  });
  map_.regions.assign(label_of_rank_.size() - 1, PlaneMoments());
  map_.accumulate(*image_);
}

// The planes of both directions that are large enough get labels, those of the columns first, and ranks by size,
// largest first; of equal ones the smaller label comes first. The others have the last rank, label 0.
void InverseDepthPipeline::rankPlanes() {
  std::vector<double> points;  // per label - 1
  std::array<std::vector<std::int32_t>, 2> label_of_plane;
  for (std::size_t k = 0; k < directions_.size(); ++k)
    for (const double plane_points : directions_[k].planePoints()) {
      if (plane_points > 0.0) points.push_back(plane_points);
      label_of_plane[k].push_back(plane_points > 0.0 ? static_cast<std::int32_t>(points.size()) : 0);
    }
  label_of_rank_.resize(points.size());
  std::iota(label_of_rank_.begin(), label_of_rank_.end(), 1);
  std::stable_sort(label_of_rank_.begin(), label_of_rank_.end(), [&](std::int32_t a, std::int32_t b) {
    return points[static_cast<std::size_t>(a - 1)] > points[static_cast<std::size_t>(b - 1)];
  });
  const auto none = static_cast<std::int32_t>(points.size());
  std::vector<std::int32_t> rank_of_label(points.size() + 1, none);
  for (std::int32_t rank = 0; rank < none; ++rank)
    rank_of_label[static_cast<std::size_t>(label_of_rank_[static_cast<std::size_t>(rank)])] = rank;
  label_of_rank_.push_back(0);

  for (std::size_t k = 0; k < directions_.size(); ++k) {
    rank_of_[k].assign(1, none);  // pixels of no segment
    if (!directions_[k].active()) continue;
    for (const int plane : directions_[k].planeOf())
      rank_of_[k].push_back(
          rank_of_label[static_cast<std::size_t>(label_of_plane[k][static_cast<std::size_t>(plane)])]);
  }
}

void InverseDepthPipeline::joinBlock(int row_begin, int row_end, int column_begin, int column_end) {
  const auto width = static_cast<std::size_t>(image_->width);
  const auto height = static_cast<std::size_t>(image_->height);
  const std::int32_t* column_segment = directions_[0].segmentOf();
  const std::int32_t* row_segment = directions_[1].segmentOf();
  const std::int32_t* column_rank = rank_of_[0].data();
  const std::int32_t* row_rank = rank_of_[1].data();
  for (auto row = static_cast<std::size_t>(row_begin); row < static_cast<std::size_t>(row_end); ++row)
    for (auto column = static_cast<std::size_t>(column_begin); column < static_cast<std::size_t>(column_end);
         ++column) {
      const std::size_t pixel = row * width + column;
      const std::int32_t c = column_segment != nullptr ? column_segment[column * height + row] : -1;
      const std::int32_t r = row_segment != nullptr ? row_segment[pixel] : -1;
      map_.labels[pixel] = label_of_rank_[static_cast<std::size_t>(std::min(column_rank[c + 1], row_rank[r + 1]))];
    }
}

void InverseDepthPipeline::mergeRegions() {
  const InverseDepthParameters::Merging& merging = grid_parameters_.expert.merging;
  const double blotch = merging.bridge_samples * grid_sensor_.pixelsPerLineSample();
  const int bridge = std::max(merging.min_bridge_pixels, static_cast<int>(blotch));
  findContacts(*image_, bridge, grid_parameters_.expert.refinement.max_residual, map_, contact_search_, contacts_);
  merger_.merge(contacts_, grid_parameters_, grid_sensor_, map_);
}

void InverseDepthPipeline::refineBoundaries() {
  epcc::refineBoundaries(*image_, grid_parameters_, map_, refinement_);
  map_.accumulate(*image_);
  mergeRegions();  // S6
}

void InverseDepthPipeline::rejectClutter() {
  rejectRegions(*image_, grid_parameters_, grid_sensor_, map_);
}

void InverseDepthPipeline::joinOccluded() {
  findOccludedContacts(*image_, grid_parameters_.expert.merging.max_occluder,
                       grid_parameters_.expert.refinement.max_residual, map_, occlusion_, contacts_);
  merger_.merge(contacts_, grid_parameters_, grid_sensor_, map_);
}

void InverseDepthPipeline::rejectThin() {
  epcc::rejectThin(*image_, grid_parameters_, grid_sensor_, stride_, map_);
}

void InverseDepthPipeline::labelPixels() {
  if (stride_ == 1) return;
  full_resolution_.label(*full_image_, samples_.noise, map_, stride_, parameters_.inverse_depth.expert.refinement,
                         parameters_.threads, pixel_labels_);
}

void InverseDepthPipeline::listSegments(const DepthFrame& frame, const std::vector<std::int32_t>& labels,
                                        std::vector<LineSegment>& segments) const {
  for (std::size_t k = 0; k < directions_.size(); ++k)
    if (directions_[k].active())
      appendSegments(k == 0 ? frame : frame.transposed(), sensor_, directions_[k].segmentOf(), labels, segments);
}

}  // namespace epcc
