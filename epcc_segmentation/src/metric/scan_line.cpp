// SPDX-License-Identifier: BSD-3-Clause
// Column of a frame -> 2-D samples.
#include "metric/scan_line.h"

namespace epcc {

void readScanLine(const DepthFrame& frame, const SensorModel& sensor, int column, ScanLine& line) {
  line.samples.clear();
  Eigen::Vector3d direction_sum = Eigen::Vector3d::Zero();
  Eigen::Vector3d p;
  for (int row = 0; row < frame.height(); ++row) {
    if (!frame.scanPoint(row, column, p)) continue;
    const double t1 = std::sqrt(p.x() * p.x() + p.z() * p.z());
    if (!(t1 > 0.0)) continue;  // on the scan axis: the line's plane is undefined there
    const double depth = frame.measuredDepth(p);
    const double sigma = sensor.sigmaZ(depth);
    const Eigen::Vector2d t(t1, p.y());
    line.samples.push_back({t, t / depth, sigma * sigma, row});
    direction_sum += Eigen::Vector3d(p.x() / t1, 0.0, p.z() / t1);
  }
  if (!line.samples.empty()) line.direction = direction_sum.normalized();
}

}  // namespace epcc
