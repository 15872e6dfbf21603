// SPDX-License-Identifier: BSD-3-Clause
// Least squares with two unknowns.
#include "laser/range_line.h"

#include <algorithm>

namespace epcc {
namespace {

constexpr double kProjectionFloor = 0.1;  // of the squared cosine, as in Algorithm 1
constexpr int kSteps = 3;                 // Gauss-Newton is there after two

/// False for a matrix that has no inverse in double precision.
bool invert(const Eigen::Matrix2d& m, Eigen::Matrix2d& inverse) {
  const double determinant = m(0, 0) * m(1, 1) - m(0, 1) * m(0, 1);
  if (!(determinant > 1e-12 * m(0, 0) * m(1, 1)) || !std::isfinite(determinant)) return false;
  inverse << m(1, 1), -m(0, 1), -m(0, 1), m(0, 0);
  inverse /= determinant;
  return true;
}

/// Of the variance: grazing beams have more, for their own width and angle count there.
double grazingFactor(const RangeLine& line, const Eigen::Vector2d& direction) {
  return std::max(1.0, kProjectionFloor / line.squaredCosine(direction));
}

}  // namespace

void RangeLineSums::add(const LaserSample& sample, double range, double sigma) {
  const double scale = range * range / sigma;  // one over sigma of the inverse range
  const Eigen::Vector2d row = scale * sample.direction;
  const double value = scale / sample.range;
  ++n_;
  normal_ += row * row.transpose();
  right_ += value * row;
  square_ += value * value;
}

RangeLineSums& RangeLineSums::operator+=(const RangeLineSums& other) {
  n_ += other.n_;
  normal_ += other.normal_;
  right_ += other.right_;
  square_ += other.square_;
  return *this;
}

bool RangeLineSums::solve(RangeLine& line) const {
  if (n_ < 2 || !invert(normal_, line.covariance)) return false;
  line.q = line.covariance * right_;
  return line.q.allFinite() && line.q.squaredNorm() > 0.0;
}

double RangeLineSums::squaredErrors(const RangeLine& line) const {
  return std::max(0.0, square_ - 2.0 * line.q.dot(right_) + line.q.dot(normal_ * line.q));
}

bool rangeError(const RangeLine& line, const LaserSample& sample, RangeError& error) {
  const double inverse = line.q.dot(sample.direction);
  if (!(inverse > 0.0)) return false;
  const double difference = sample.range - 1.0 / inverse;
  error.squared = difference * difference;
  error.variance = sample.sigma * sample.sigma * grazingFactor(line, sample.direction);
  return true;
}

double fitRangeLine(const std::vector<LaserSample>& samples, const std::vector<int>& members, const SensorModel& noise,
                    RangeLine& line) {
  double errors = -1.0;
  for (int step = 0; step < kSteps; ++step) {
    Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
    Eigen::Vector2d right = Eigen::Vector2d::Zero();
    errors = 0.0;
    for (const int i : members) {
      const LaserSample& sample = samples[i];
      const double range = line.range(sample.direction);
      if (!(range > 0.0) || !std::isfinite(range)) return -1.0;
      const double sigma = noise.sigmaZ(range) * std::sqrt(grazingFactor(line, sample.direction));
      const Eigen::Vector2d row = (-range * range / sigma) * sample.direction;
      const double error = (sample.range - range) / sigma;
      normal += row * row.transpose();
      right += error * row;
      errors += error * error;
    }
    if (!invert(normal, line.covariance)) return -1.0;
    line.q += line.covariance * right;
    if (!line.q.allFinite()) return -1.0;
  }
  return errors;
}

}  // namespace epcc
