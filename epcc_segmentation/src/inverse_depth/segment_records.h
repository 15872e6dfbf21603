// SPDX-License-Identifier: BSD-3-Clause
// The line segments of S1 in metres, with the labels that their pixels have in the end.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "epcc_segmentation/depth_frame.h"
#include "epcc_segmentation/line_segment.h"
#include "epcc_segmentation/sensor_model.h"
#include "inverse_depth/grid_steps.h"
#include "segment_fit.h"

namespace epcc {

/// Each sample's segment by its number within its column of a view, -1 none.
struct GridSegmentNumbers {
  const std::int32_t* numbers = nullptr;
  std::size_t next_column = 0, next_row = 0;  ///< steps
  GridSteps steps = {};                       ///< of the samples, in the view
  /// Of each sample the pixel that it is, next_pixel_row * row + next_pixel_column * column of the view; null: the grid
  /// says it.
  const std::int32_t* pixels = nullptr;
  int next_pixel_row = 0, next_pixel_column = 0;

  /// Of a sample, by its place in the grid.
  std::int32_t at(int row, int column) const { return numbers[place(row, column)]; }
  std::size_t place(int row, int column) const {
    return static_cast<std::size_t>(row) * next_row + static_cast<std::size_t>(column) * next_column;
  }
};

/// Appends the segments of those columns of the view that are scan lines of the grid. `labels` are the final ones, in
/// the order of the caller's arrays. Each is given to `fitter`, which is to finish them.
void appendSegments(const DepthFrame& view, const SensorModel& sensor, const GridSegmentNumbers& segment_of,
                    const std::vector<std::int32_t>& labels, SegmentFitter& fitter, std::vector<LineSegment>& segments);

}  // namespace epcc
