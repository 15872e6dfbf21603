// SPDX-License-Identifier: BSD-3-Clause
// A line seen by beams from one place, with additive statistics in inverse range.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstddef>
#include <vector>

#include "epcc_segmentation/laser_scan.h"
#include "epcc_segmentation/sensor_model.h"

namespace epcc {

/// A return.
struct LaserSample {
  Eigen::Vector2d direction;  ///< (cos, sin) of the beam
  double range;               ///< metres
  double sigma;               ///< of the range, metres
  int beam;                   ///< in the scan

  Eigen::Vector2d point() const { return range * direction; }
};

/// 1/r = q . direction; q is the line's normal divided by its distance.
struct RangeLine {
  Eigen::Vector2d q = Eigen::Vector2d::Zero();
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();  ///< of q, by the noise model

  /// Where a beam meets the line; negative or infinite where it does not.
  double range(const Eigen::Vector2d& direction) const { return 1.0 / q.dot(direction); }
  Eigen::Vector2d point(const Eigen::Vector2d& direction) const { return range(direction) * direction; }
  /// Unit vector along the line.
  Eigen::Vector2d along() const { return Eigen::Vector2d(-q.y(), q.x()) / q.norm(); }
  /// Squared cosine of the angle between a beam and the normal.
  double squaredCosine(const Eigen::Vector2d& direction) const {
    const double projection = q.dot(direction);
    return projection * projection / q.squaredNorm();
  }
  /// Variance of range(direction), m^2.
  double rangeVariance(const Eigen::Vector2d& direction) const {
    const double r = range(direction);
    return r * r * r * r * direction.dot(covariance * direction);
  }
};

/// Weighted sums of samples; they add up and determine the line.
class RangeLineSums {
 public:
  void add(const LaserSample& sample) { add(sample, sample.range, sample.sigma); }
  /// With the weight of another range, for example that of the line.
  void add(const LaserSample& sample, double range, double sigma);
  RangeLineSums& operator+=(const RangeLineSums& other);
  int n() const { return n_; }
  /// False if the samples determine no line.
  bool solve(RangeLine& line) const;
  /// Sum of squared errors in units of sigma.
  double squaredErrors(const RangeLine& line) const;

 private:
  int n_ = 0;
  Eigen::Matrix2d normal_ = Eigen::Matrix2d::Zero();
  Eigen::Vector2d right_ = Eigen::Vector2d::Zero();
  double square_ = 0.0;
};

/// What Eq. 20 compares of a sample and a line, m^2.
struct RangeError {
  double squared;   ///< error along the beam
  double variance;  ///< sigma_r^2; grazing beams have more, for their own width and angle count there
};
/// False if the beam does not meet the line.
bool rangeError(const RangeLine& line, const LaserSample& sample, RangeError& error);

/// Most probable line of the samples: errors of ranges in units of sigma at the line's own range, more for grazing
/// beams as above, by Gauss-Newton from `line`. Returns the sum of squared errors, or a negative number if there is no
/// such line.
double fitRangeLine(const std::vector<LaserSample>& samples, const std::vector<int>& members, const SensorModel& noise,
                    RangeLine& line);

}  // namespace epcc
