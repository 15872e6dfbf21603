// SPDX-License-Identifier: BSD-3-Clause
// Points of a cloud in the sensor's frame, and which of them the sensor can have measured.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <limits>

#include "epcc_segmentation/cloud_geometry.h"

namespace epcc {

/// Points -> the sensor's frame, in single precision about the sensor. What decides on a pixel asks here, for in
/// another precision another pixel may be the one that lies at the sensor or at the end of the range.
class RigidMap {
 public:
  explicit RigidMap(const CloudGeometry& geometry)
      : is_scanner_(geometry.projection == Projection::Spherical),
        is_backward_(geometry.projection == Projection::PerspectiveBackward),
        has_range_(geometry.min_depth > 0.0 || std::isfinite(geometry.max_depth)),
        min_depth_(geometry.min_depth),
        max_depth_(geometry.max_depth) {
    for (int i = 0; i < 3; ++i) {
      origin_[i] = static_cast<float>(geometry.pose.origin(i) / geometry.unit);
      for (int k = 0; k < 3; ++k) m_[i][k] = static_cast<float>(geometry.pose.axes(k, i) * geometry.unit);
    }
    least_ = static_cast<float>(kRounding * Eigen::Vector3d(geometry.pose.origin).norm());
  }

  void apply(const float* p, float* s) const {
    const float x = p[0] - origin_[0], y = p[1] - origin_[1], z = p[2] - origin_[2];
    for (int i = 0; i < 3; ++i) s[i] = m_[i][0] * x + m_[i][1] * y + m_[i][2] * z;
  }

  /// Whether a point in the sensor's frame was measured: farther from the sensor than its coordinates were rounded, and
  /// within the range. What a driver gives for no return is at the sensor, and moves with it.
  bool isMeasured(const float* s) const {
    if (is_scanner_) {
      if (!(s[0] * s[0] + s[1] * s[1] + s[2] * s[2] > least_ * least_)) return false;
      return !has_range_ || isInRange(std::hypot(s[0], s[1], s[2]));
    }
    const float depth = is_backward_ ? -s[2] : s[2];
    return depth > least_ && (!has_range_ || isInRange(depth));
  }

 private:
  static constexpr double kRounding = 4.0 * std::numeric_limits<float>::epsilon();  // of coordinates, and of `m`

  bool isInRange(float depth) const {
    return static_cast<double>(depth) >= min_depth_ && static_cast<double>(depth) <= max_depth_;
  }

  bool is_scanner_, is_backward_, has_range_;
  double min_depth_, max_depth_;  // m
  float m_[3][3];
  float origin_[3];  // in units of the cloud
  float least_;      // m
};

}  // namespace epcc
