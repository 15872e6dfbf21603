// SPDX-License-Identifier: BSD-3-Clause
// S1 and S2 in one scan direction: samples -> line segments -> planes.
#pragma once

#include <cstdint>
#include <vector>

#include "epcc_segmentation/parameters.h"
#include "epcc_segmentation/sensor_model.h"
#include "inverse_depth/inverse_depth_image.h"
#include "inverse_depth/line_growing.h"
#include "inverse_depth/plane_growing.h"

namespace epcc {

/// Planes grown from the columns, or from the rows, of an image. Keeps its memory between frames.
class DirectionalPlanes {
 public:
  DirectionalPlanes(bool columns, const InverseDepthParameters& parameters, const SensorModel& sensor);
  void configure(const InverseDepthParameters& parameters, const SensorModel& sensor);

  /// A direction that is not active has no segments and no planes.
  void setActive(bool active);
  bool active() const { return active_; }
  void growLines(const InverseDepthImage& image);   ///< S1
  void growPlanes(const InverseDepthImage& image);  ///< S2

  /// Per pixel, scan line by scan line: the segment, -1 none. Null if the direction is not active.
  const std::int32_t* segmentOf() const { return active_ ? segment_of_.data() : nullptr; }
  /// Per segment: its plane.
  const std::vector<int>& planeOf() const { return plane_growing_.planeOf(); }
  /// Per plane: its pixels, 0 if it is too small.
  const std::vector<double>& planePoints() const { return plane_points_; }

 private:
  bool columns_;
  bool active_ = false;
  InverseDepthParameters::Planes parameters_;
  LineGrowing line_growing_;
  PlaneGrowing plane_growing_;
  std::vector<GrownLine> lines_;
  std::vector<std::size_t> line_begin_;  // per scan line, into lines_; one more at the end
  std::vector<std::int32_t> segment_of_;
  std::vector<double> plane_points_;
};

}  // namespace epcc
