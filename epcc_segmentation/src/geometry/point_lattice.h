// SPDX-License-Identifier: BSD-3-Clause
// Points of a cloud on some rows and columns spread over it: what its geometry is known by.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "epcc_segmentation/cloud_geometry.h"

namespace epcc {

/// A cloud's points in the caller's memory.
struct CloudView {
  const float* xyz = nullptr;
  std::size_t stride = 0;
  int width = 0;
  int height = 0;
};

/// The points where some rows cross some columns. Keeps its memory.
class PointLattice {
 public:
  struct Point {
    int row, column;  ///< which of rows() and columns()
    Eigen::Vector3d p;
  };

  /// At most so many rows and columns. Zeros and what is not finite are left out, and so are `invalid` and points that
  /// stand in many places: no ray meets another, so that they stand for nothing measured. Those go to `markers`.
  void read(const CloudView& cloud, int max_rows, int max_columns, const std::optional<float>& invalid,
            std::vector<Vector3f>& markers);

  const std::vector<int>& rows() const { return rows_; }
  const std::vector<int>& columns() const { return columns_; }
  const std::vector<Point>& points() const { return points_; }
  /// Every row and column of the cloud.
  bool isWhole(const CloudView& cloud) const;

 private:
  void dropRepeated(std::vector<Vector3f>& markers);

  std::vector<int> rows_, columns_;
  std::vector<Point> points_;
  std::vector<std::size_t> first_, repeats_;
};

}  // namespace epcc
