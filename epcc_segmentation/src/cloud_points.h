// SPDX-License-Identifier: BSD-3-Clause
// Part of an organized cloud -> x, y and z in arrays of their own, in vectors.
#pragma once

#include <cstddef>

#include "epcc_segmentation/depth_frame.h"

namespace epcc {

/// Rows of a cloud from `row` on and of each the columns column + step * i.
struct CloudPart {
  int row = 0, rows = 1;
  int column = 0, columns = 0, step = 1;
};

/// Coordinates, rows of `pitch` points; what is in a row beyond the part's columns must be 0.
struct PointArrays {
  float* x;
  float* y;
  float* z;
  std::size_t pitch;
};

/// For the kernels: where the points lie, steps in floats.
struct PointGrid {
  const float* first;
  std::size_t rows, columns;
  std::size_t row_step, column_step;
  bool has_fourth;  ///< a fourth float may be read behind each of them
};

/// For the kernels: z of a point has the sign of `forward`, of 0 any point but the origin is one; no coordinate is
/// beyond `farthest`; they are given times `sign`.
struct PointCheck {
  float forward;
  float farthest;
  float sign[3];
};

/// The points in the sensor's own frame, zeros where nothing is measured.
void readPoints(const DepthFrame& cloud, const CloudPart& part, const PointArrays& points);

/// The points in the scan frame, zeros where nothing is measured or a coordinate exceeds `farthest`.
void readScanPoints(const DepthFrame& cloud, const CloudPart& part, float farthest, const PointArrays& points);

}  // namespace epcc
