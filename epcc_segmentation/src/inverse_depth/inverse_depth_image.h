// SPDX-License-Identifier: BSD-3-Clause
// A frame as inverse depths over a grid of rays, the form in which planes are linear.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <vector>

#include "epcc_segmentation/depth_frame.h"
#include "epcc_segmentation/sensor_model.h"
#include "inverse_depth/grid_steps.h"
#include "inverse_depth/perspective_points.h"

namespace epcc {

/// Variance of an inverse depth as a function of the inverse depth: no division, no branch.
struct InverseDepthNoise {
  double k1 = 0.0, k2 = 0.0, k3 = 0.0;  // polynomial form: (k1 + k2 w + k3 w^2)^2
  double a2 = 0.0, b2 = 0.0;            // axial form: b^2 + a^2 w^4
  /// Variance of the place within its pixel that a value comes from, in ray coordinates. On a surface inclined by 45
  /// degrees an error of the place is an equal error of the depth, so this is the smallest variance that any depth is
  /// given. Measured sensor models contain it; it matters for models with almost no error, such as `rendered`.
  double place2 = 0.0;

  static InverseDepthNoise of(const SensorModel& sensor);
  double variance(double w) const {
    const double s = k1 + w * (k2 + w * k3);
    const double w2 = w * w;
    return std::max(s * s + b2 + a2 * w2 * w2, place2 * w2);
  }
};

/// Rays are (across[column], along[row], forward[column]); a plane not through the sensor is
/// q . ray = w. Pinhole images and perspective clouds: forward = 1, w = 1/z, across and along the usual
/// u = (c - cx)/fx, v = (r - cy)/fy. Spherical scans: (across, forward) is the unit vector of the
/// column's azimuth, along the tangent of the row's elevation, w = 1/t1 the inverse horizontal distance.
struct InverseDepthImage {
  int width = 0;
  int height = 0;
  bool planar_rows = true;              ///< rows are planar sections too (false for spherical scans)
  bool closes_round = false;            ///< the last column adjoins the first
  std::vector<float> w;                 ///< row-major, 0 = invalid
  std::vector<float> weight;            ///< 1/sigma_w^2 of each; meaningless where w is 0
  std::vector<double> across, forward;  ///< per column
  std::vector<double> along;            ///< per row
  /// Per row: measured inverse depth = w * measured_scale; 1 for perspective frames, cos(elevation) for scans.
  std::vector<double> measured_scale;
  InverseDepthNoise noise;
  GridSteps steps;  ///< pixels of the frame that one of this image stands for
  /// Of an image of ScatteredPixels: the place variance of a pixel of its frame, and what its samples lie beside their
  /// rows and columns.
  double place_of_pixel = 0.0, place_beside = 0.0;

  Eigen::Vector3d ray(int row, int column) const {
    return {across[static_cast<std::size_t>(column)], along[static_cast<std::size_t>(row)],
            forward[static_cast<std::size_t>(column)]};
  }
  /// Of a pixel in w and weight.
  std::size_t index(int row, int column) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column);
  }
  /// A value may come from anywhere in its pixel: the variance of an even distribution over it, in ray coordinates,
  /// mean of both directions.
  double placeVariance() const;

  /// Reads a frame; memory is reused. Cloud rays are estimated per row and column from the points. Of a depth image
  /// with a stride the depths of every stride-th row and column from stride / 2 on are kept.
  void read(const DepthFrame& frame, int threads = 1, int stride = 1);
  /// Those that were kept, row after row, and kBehindDepths values more; null if there are none.
  const float* sampleDepths() const { return keeps_depths_ ? sample_depths_.data() : nullptr; }
  static constexpr std::size_t kBehindDepths = 16;
  /// Takes every stride-th row and column of an image, from stride / 2 on; at least one of each.
  void sample(const InverseDepthImage& image, int stride, int threads = 1);
  /// What the sensor says of it: noise and weights. A value may come from anywhere within its pixel, the one that was
  /// measured: on an image that was sampled, place_variance is that of the original.
  void weigh(const SensorModel& sensor, double place_variance, int threads = 1);
  void weigh(const SensorModel& sensor) { weigh(sensor, placeVariance()); }

 private:
  void readDepths(const DepthFrame& frame, int threads, int stride);
  void readPoints(const DepthFrame& frame);
  void readScan(const DepthFrame& frame);

  PerspectivePoints points_;
  std::vector<double> column_count_, row_count_;  // valid points of a cloud
  std::vector<float> row_depths_;                 // a row for each thread
  std::vector<float> sample_depths_;
  bool keeps_depths_ = false;
};

/// How many of `count` values are samples: every stride-th from stride / 2 on; never none.
int sampleCount(int count, int stride);
/// Which of the samples lies at a place, -1 none.
int sampleAt(int place, int stride, int count);

/// Mean change of a ray coordinate from one column or row to the next.
double pixelPitch(const std::vector<double>& coordinate);

}  // namespace epcc
