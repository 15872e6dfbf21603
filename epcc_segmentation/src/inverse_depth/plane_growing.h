// SPDX-License-Identifier: BSD-3-Clause
// S2: one pass over the scan lines of one direction clusters their segments into planes.
#pragma once

#include <vector>

#include "epcc_segmentation/parameters.h"
#include "epcc_segmentation/sensor_model.h"
#include "inverse_depth/line_growing.h"
#include "inverse_depth/plane_moments.h"

namespace epcc {

/// A plane prototype while it grows.
struct GrownPlane {
  PlaneMoments moments;
  PlaneEstimate estimate;
  double ridge = 0.0;
  int segments = 0;
};

/// Where a scan line lies: its segments have the rays base + x * axis, x the coordinate along the line.
struct ScanLineRays {
  Eigen::Vector3d base;
  Eigen::Vector3d axis;
};

/// S2 as an object that is fed the segments of one scan line at a time, in order.
class PlaneGrowing {
 public:
  PlaneGrowing(const InverseDepthParameters& parameters, const SensorModel& sensor) { configure(parameters, sensor); }
  void configure(const InverseDepthParameters& parameters, const SensorModel& sensor);

  /// Forgets everything; `pixel_pitch` is the mean step of x from pixel to pixel, 1/f.
  void begin(double pixel_pitch);
  void addLine(const ScanLineRays& rays, const GrownLine* lines, std::size_t count);

  /// Plane index of each segment in order of feeding.
  const std::vector<int>& planeOf() const { return plane_of_; }
  const std::vector<GrownPlane>& planes() const { return planes_; }

 private:
  double mismatch(const GrownPlane& plane, const ScanLineRays& rays, const GrownLine& line) const;

  double k_max_ = 0.0;
  InverseDepthParameters::Planes parameters_;
  double pixels_per_sample_ = 1.0;       // L
  double pixels_per_line_sample_ = 1.0;  // L1
  double correlation_length_ = 0.0;      // l, pixels
  double sample_spread_ = 0.0;           // (l / f)^2
  std::vector<GrownLine> previous_;
  std::size_t previous_begin_ = 0;
  std::vector<int> plane_of_;
  std::vector<GrownPlane> planes_;
};

/// Moments of a segment, from its sums and its scan line's rays.
PlaneMoments segmentMoments(const ScanLineRays& rays, const LineSums& sums);

}  // namespace epcc
