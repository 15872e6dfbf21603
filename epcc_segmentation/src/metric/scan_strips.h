// SPDX-License-Identifier: BSD-3-Clause
// Cuts a view into strips of neighbouring scan lines whose samples lie side by side, row by row.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "epcc_segmentation/depth_frame.h"
#include "metric/line_clustering.h"

namespace epcc {

/// The strips of one view after another; keeps its memory.
class ScanStrips {
 public:
  /// The view's columns are the scan lines. A depth image is read here, a cloud strip by strip.
  void begin(const DepthFrame& view);
  int count() const { return static_cast<int>(padded_ / kStripLines); }
  /// Width in pixels, up to whole strips.
  std::size_t paddedWidth() const { return padded_; }

  /// Rows of paddedWidth() depths, 0 where nothing is measured; null unless the view is that of a depth image.
  const float* depth() const { return has_depth_ ? depth_.data() : nullptr; }

  /// Strip of the lines from kStripLines * strip on. `memory` holds what is read here, until the next call with it.
  ScanStrip strip(const DepthFrame& view, int strip, std::vector<float>& memory) const;

  /// Unit vector of t1 of a line in the scan frame (Eq. 9 with the sign repaired), from what the strip's clustering
  /// found of a cloud.
  Eigen::Vector3d direction(const DepthFrame& view, int column, const float* sum) const;

 private:
  ScanStrip fromImage(int strip) const;
  ScanStrip fromRows(const DepthFrame& view, int strip, std::vector<float>& memory) const;
  ScanStrip fromPoints(const DepthFrame& view, int strip, std::vector<float>& memory) const;

  int height_ = 0;
  bool has_depth_ = false;
  std::size_t padded_ = 0;
  float farthest_ = 0.0f;      // depth
  std::vector<float> depth_;   // of a depth image by columns, rows of padded_ pixels
  std::vector<float> secant_;  // sqrt(1 + u^2) of the columns
  std::vector<float> along_;   // v of the rows
};

}  // namespace epcc
