// SPDX-License-Identifier: BSD-3-Clause
// Collects scan lines as they come until Algorithm 1 takes them side by side.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "epcc_segmentation/stream_geometry.h"
#include "label_sums.h"
#include "metric/line_clustering.h"

namespace epcc {

/// Up to kStripLines scan lines of a stream. Keeps its memory.
class CollectedStrip {
 public:
  void begin(const StreamGeometry& geometry);
  int size() const { return size_; }
  void clear() { size_ = 0; }

  void addDepths(std::int64_t index, const float* depth, std::ptrdiff_t stride);
  void addRanges(double azimuth, const float* ranges, std::ptrdiff_t stride);
  void addPoints(const float* xyz, std::ptrdiff_t stride);

  /// The lines for Algorithm 1.
  ScanStrip strip();
  /// Unit vector of t1 of a line in the scan frame; `sum` as found in a strip of points.
  Eigen::Vector3d direction(int line, const float* sum) const;
  /// A line's samples for the sums over planes, without labels and memory.
  SampleRow row(int line) const;
  /// From the frame of these sums to the sensor's own.
  const Eigen::Matrix3d& axes() const { return axes_; }

 private:
  bool isCamera() const { return z_only_; }
  float* line(int coordinate) {
    return lines_.data() +
           (static_cast<std::size_t>(coordinate) * kStripLines + static_cast<std::size_t>(size_)) * pitch_;
  }
  const float* line(int coordinate, int i) const {
    return lines_.data() + (static_cast<std::size_t>(coordinate) * kStripLines + static_cast<std::size_t>(i)) * pitch_;
  }
  float* side(int coordinate) {
    return side_by_side_.data() + static_cast<std::size_t>(coordinate) * height_ * kStripLines;
  }
  void laySideBySide(int coordinate);
  void setAcross(double u);

  bool z_only_ = false;
  bool depth_is_range_ = false;
  std::size_t height_ = 0;
  std::size_t pitch_ = 0;  // of the lines on their own: sums may read behind the last sample
  int size_ = 0;
  Projection projection_ = Projection::Perspective;
  Eigen::Matrix3d axes_ = Eigen::Matrix3d::Identity();
  // Of a camera: focal length and centre across the lines, slopes of the rays along and across them.
  double focus_ = 1.0, centre_ = 0.0;
  double largest_slope_ = 0.0;  // of what is known of the frame
  std::vector<float> along_;
  std::vector<double> along_exact_;
  float secant_[kStripLines] = {};
  double across_[kStripLines] = {};
  // Of a scanner.
  std::vector<double> cosine_, sine_;  // of the rings' elevations
  // x, y, z in the scan frame, of a camera z alone; each of the lines on its own, then row by row beside the others.
  std::vector<float> lines_;
  std::vector<float> side_by_side_;
};

}  // namespace epcc
