// SPDX-License-Identifier: BSD-3-Clause
// S2: one pass over the scan lines of one direction clusters their segments into planes.
#pragma once

#include <vector>

#include "epcc_segmentation/parameters.h"
#include "epcc_segmentation/sensor_model.h"
#include "inverse_depth/line_growing.h"

namespace epcc {

/// Where a scan line lies: its samples have the rays (side, x, forward), x the coordinate along the line.
struct ScanLineRays {
  double side = 0.0;
  double forward = 1.0;
};

/// The six values of a symmetric matrix over rays.
struct SymmetricMatrix {
  double ss = 0.0, sx = 0.0, sf = 0.0, xx = 0.0, xf = 0.0, ff = 0.0;

  SymmetricMatrix inverse() const;
};

/// Sums over the samples of segments, of weight 1/sigma_w^2.
struct SegmentMoments {
  double n = 0.0;
  SymmetricMatrix rays;                             ///< of ray ray^T
  double side_w = 0.0, x_w = 0.0, forward_w = 0.0;  ///< of ray w

  void add(const ScanLineRays& rays, const GrownLine& line);
};

/// A plane prototype while it grows: q . ray = w with q = (M + ridge (e e^T + x x^T))^-1 b, e across the scan lines,
/// fitted when it is asked for.
struct GrownPlane {
  SegmentMoments moments;
  double ridge = 0.0;
  bool turning = false;  ///< scan lines of a scan: side and forward are a unit vector
  int segments = 0;
  bool fitted = false;
  SymmetricMatrix inverse;
  double q_side = 0.0, q_x = 0.0, q_forward = 0.0;

  void fit();
};

/// S2 as an object that is fed the segments of one scan line at a time, in order.
class PlaneGrowing {
 public:
  PlaneGrowing(const InverseDepthParameters& parameters, const SensorModel& sensor) { configure(parameters, sensor); }
  void configure(const InverseDepthParameters& parameters, const SensorModel& sensor);

  /// Forgets everything; `pixel_pitch` is the mean step of x from pixel to pixel, 1/f. The columns of a scan
  /// turn: their side and forward are a unit vector.
  void begin(double pixel_pitch, bool turning);
  /// Segments lie side by side, in order. They must stay where they are until the next scan line was added.
  void addLine(const ScanLineRays& rays, const GrownLine* lines, int count);

  /// Plane index of each segment in order of feeding.
  const std::vector<int>& planeOf() const { return plane_of_; }
  const std::vector<GrownPlane>& planes() const { return planes_; }

 private:
  int findPlane(const ScanLineRays& rays, const GrownLine& line, int first_candidate);
  int startPlane(const GrownLine& line);

  double k_max_ = 0.0;
  InverseDepthParameters::Planes parameters_;
  double pixels_per_sample_ = 1.0;       // L
  double pixels_per_line_sample_ = 1.0;  // L1
  double correlation_length_ = 0.0;      // l, pixels
  double sample_spread_ = 0.0;           // (l / f)^2
  bool turning_ = false;
  ScanLineRays previous_rays_;
  double unknown_slope2_ = 0.0;  // what w/mean_w may change by from one column to the next, squared
  const GrownLine* previous_ = nullptr;
  int previous_count_ = 0;
  int empty_lines_ = 0;
  std::size_t previous_begin_ = 0;  // in plane_of_
  std::vector<int> plane_of_;
  std::vector<GrownPlane> planes_;
};

}  // namespace epcc
