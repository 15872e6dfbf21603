// SPDX-License-Identifier: BSD-3-Clause
// The rays of a frame's pixels, and of all places between them, in the sensor's scan frame.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "epcc_segmentation/depth_frame.h"
#include "epcc_segmentation/plane_segmentation.h"
#include "epcc_segmentation/sensor_model.h"

namespace epcc {

/// A coordinate that goes on from pixel to pixel, known at whole numbers.
class RayTable {
 public:
  RayTable() = default;
  explicit RayTable(std::vector<double> values);
  double at(double place) const;
  double slope(double place) const;

 private:
  std::size_t interval(double place) const;
  std::vector<double> values_;
};

/// Rays in the order of the scan: columns and rows of a scanner are its own, whatever the cloud's are. Rays are not of
/// unit length: (u, v, 1) of a camera; (sin azimuth, tan elevation, cos azimuth) of a scanner. A point is ray / w, w
/// the inverse depth (of a scan the inverse horizontal distance), and a plane n . p + d = 0 has w = q . ray, q = -n /
/// d.
class PixelRays {
 public:
  static constexpr std::size_t kNoPixel = std::numeric_limits<std::size_t>::max();

  /// The frame must outlive it.
  explicit PixelRays(const DepthFrame& frame);

  int width() const { return width_; }
  int height() const { return height_; }
  bool closesRound() const { return closes_round_; }
  std::size_t index(int row, int column) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(column);
  }
  /// The pixel's place in the caller's arrays; kNoPixel where the scan has a column more than the cloud.
  std::size_t callersPixel(int row, int column) const;

  /// Pixel centres are at whole numbers.
  Eigen::Vector3d ray(double column, double row) const;
  /// How the ray changes by a column, and by a row.
  Eigen::Vector3d rayByColumn(double column) const;
  Eigen::Vector3d rayByRow(double row) const;
  /// The ray of a pixel's centre.
  Eigen::Vector3d ray(int column, int row) const {
    const Eigen::Vector2d& across = column_rays_[static_cast<std::size_t>(column)];
    return {across.x(), row_rays_[static_cast<std::size_t>(row)], across.y()};
  }
  /// ray . (ray by column x ray by row) over a pixel, positive: it covers this * |q| / w^3 of the plane q.
  double pixelDeterminant(int column, int row) const {
    return column_steps_[static_cast<std::size_t>(column)] * row_steps_[static_cast<std::size_t>(row)];
  }

  /// w of what the pixel measured, 0 if nothing.
  float measured(int row, int column) const { return measured_[index(row, column)]; }
  /// What the sensor calls the depth of a point ray / w.
  double depth(const Eigen::Vector3d& ray, double w) const { return (is_camera_ ? 1.0 : ray.norm()) / w; }
  /// Standard deviation of w.
  double sigma(const SensorModel& sensor, const Eigen::Vector3d& ray, double w) const {
    const double z = depth(ray, w);
    return w * sensor.sigmaZ(z) / z;
  }

  /// The plane of the caller's frame as q of the scan frame; false for one through the sensor.
  bool inverseDepthPlane(const Plane& plane, Eigen::Vector3d& q) const;
  /// A point of the scan frame in the caller's.
  Eigen::Vector3d toCaller(const Eigen::Vector3d& scan_point) const { return frame_.fromScan(scan_point); }
  /// Labels in the order of the scan; what is not in 1..count is 0.
  std::vector<std::int32_t> scanLabels(const std::vector<std::int32_t>& labels, int count) const;

 private:
  void readRays();

  DepthFrame frame_;
  int width_ = 0, height_ = 0;
  bool is_camera_ = true;
  bool closes_round_ = false;
  RayTable across_, along_;                   // of a scanner azimuth and tan elevation
  std::vector<Eigen::Vector2d> column_rays_;  // of pixel centres: across and forward
  std::vector<double> row_rays_;
  std::vector<double> column_steps_, row_steps_;  // from edge to edge of a pixel
  std::vector<float> measured_;
};

}  // namespace epcc
