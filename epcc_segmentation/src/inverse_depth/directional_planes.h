// SPDX-License-Identifier: BSD-3-Clause
// S1 and S2 in one scan direction: samples -> line segments -> planes.
#pragma once

#include <cstdint>
#include <vector>

#include "epcc_segmentation/parameters.h"
#include "epcc_segmentation/sensor_model.h"
#include "inverse_depth/inverse_depth_image.h"
#include "inverse_depth/line_strips.h"
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

  /// S1: makes room, then the strips are grown in any order.
  void beginLines(const InverseDepthImage& image, const InverseDepthParameters& parameters);
  int strips() const { return active_ ? lines_.strips() : 0; }
  void makeRoom(StripMemory& memory) const { lines_.makeRoom(memory); }
  void growStrip(const InverseDepthImage& image, int strip, StripMemory& memory) { lines_.grow(image, strip, memory); }
  /// S2
  void growPlanes(const InverseDepthImage& image);

  const LineStrips& lines() const { return lines_; }
  /// Per segment, scan line by scan line: its plane.
  const std::vector<int>& planeOf() const { return plane_growing_.planeOf(); }
  /// Per plane: its pixels, 0 if it is too small.
  const std::vector<double>& planePoints() const { return plane_points_; }

 private:
  bool columns_;
  bool active_ = false;
  InverseDepthParameters::Planes parameters_;
  LineStrips lines_;
  PlaneGrowing plane_growing_;
  std::vector<double> plane_points_;
};

}  // namespace epcc
