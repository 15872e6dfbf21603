// SPDX-License-Identifier: BSD-3-Clause
// Organized clouds of a camera -> inverse depths and ray sums, several rows at a time.
#pragma once

#include <cstddef>
#include <vector>

#include "epcc_segmentation/depth_frame.h"

namespace epcc {

/// Reads perspective clouds row by row; keeps its memory from frame to frame.
class PerspectivePoints {
 public:
  /// w = 1/z of each pixel, 0 for an invalid one, into rows of `stride` floats; the sums of x/z over the columns'
  /// valid points and of y/z over the rows', each in the order of the pixels, and how many they are. `across`,
  /// `along` and their counts hold zeros for each column and row before.
  void read(const DepthFrame& frame, std::size_t stride, float* w, double* across, double* column_count, double* along,
            double* row_count);

 private:
  std::vector<float> points_;  // of a row that cannot be read in its place
  std::vector<double> slope_;  // y/z of a few rows, 0 for invalid pixels
};

}  // namespace epcc
