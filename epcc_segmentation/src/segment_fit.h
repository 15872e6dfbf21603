// SPDX-License-Identifier: BSD-3-Clause
// The line that is likeliest to have given a segment's depths along their rays, and the covariance of its parameters.
#pragma once

#include <vector>

#include "correlated_error.h"
#include "epcc_segmentation/line_segment.h"
#include "epcc_segmentation/sensor_model.h"
#include "metric/scan_line.h"

namespace epcc {

/// Sets theta and theta_covariance of the segments of one frame: fitAlongRays() with one dimension less.
class SegmentFitter {
 public:
  SegmentFitter(const SensorModel& sensor, const ErrorCorrelation& error) : sensor_(sensor), error_(error) {}

  /// Pixels from sample to sample along the scan lines to come.
  void setStride(int stride);
  /// A segment with its mean and covariance, and its samples in order. Moves the orthogonal line to the least squares
  /// of what the samples are off along their rays, by one step in theta. The covariance
  /// waits for its unit: finish().
  void fit(const std::vector<const ScanSample*>& samples, LineSegment& segment);
  /// The segments that were fitted, in that order. The unit of each is the mean square of its residuals and, as if it
  /// were that of some more samples, the mean square over the segments of the frame's planes: few samples with alike
  /// errors leave residuals that say nothing.
  void finish(LineSegment* segments) const;

 private:
  struct Residuals {
    double squares = 0.0;      ///< in units of the sensor model
    double freedom = 0.0;      ///< what they would be on average if the model's unit were right
    double independent = 0.0;  ///< degrees of freedom that tell of the unit
  };
  double frameUnit(const LineSegment* segments) const;

  SensorModel sensor_;
  ErrorCorrelation error_;
  std::vector<double> correlation_;  // of samples 0, 1, 2, ... apart
  std::vector<Residuals> residuals_;
};

}  // namespace epcc
