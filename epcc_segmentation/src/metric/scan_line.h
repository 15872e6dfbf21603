// SPDX-License-Identifier: BSD-3-Clause
// One scan line of a frame as 2-D samples in its plane through the sensor (Sec. 4.1).
#pragma once

#include <Eigen/Core>
#include <vector>

#include "epcc_segmentation/depth_frame.h"
#include "epcc_segmentation/sensor_model.h"

namespace epcc {

/// A valid sample of a scan line.
struct ScanSample {
  Eigen::Vector2d t;       ///< (t1, t2): distance in the across-forward plane, coordinate along the line; metres
  Eigen::Vector2d ray;     ///< t divided by the measured depth
  double sensor_variance;  ///< sigma_z^2 at the measured depth, m^2
  int position;            ///< pixel position along the scan line
};

/// A scan line: the plane it lies in and its valid samples in order. Invalid pixels are skipped, they end nothing.
struct ScanLine {
  /// Unit vector of t1 in the scan frame; t2 is the frame's y axis (Eq. 9 with the sign repaired).
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();
  std::vector<ScanSample> samples;

  /// Point of the scan frame, Eqs. 3-8 inverted: z = t1 / sqrt(1 + u^2), x = u z, y = t2.
  Eigen::Vector3d lift(const Eigen::Vector2d& t) const { return {t.x() * direction.x(), t.y(), t.x() * direction.z()}; }
};

/// Fills `line` with column `column` of the frame; its memory is reused.
void readScanLine(const DepthFrame& frame, const SensorModel& sensor, int column, ScanLine& line);

}  // namespace epcc
