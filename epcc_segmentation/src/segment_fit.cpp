// SPDX-License-Identifier: BSD-3-Clause
// One Gauss-Newton step in theta, in the axes of a segment's offset and slope.
#include "segment_fit.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "metric/recursive_statistics.h"

namespace epcc {

namespace {

constexpr double kNearestSample = 0.5, kFarthestSample = 2.0;  // a sample's distance over that of the line
constexpr double kLargestLineStep = 0.2;                       // relative, between two fits of a line
// Degrees of freedom that the frame's mean square is worth beside a segment's own: surfaces differ by a third or so.
constexpr double kWorthOfFrame = 10.0;

/// Normal equations of the step.
struct LineStep {
  Eigen::Matrix2d information = Eigen::Matrix2d::Zero();
  Eigen::Vector2d gradient = Eigen::Vector2d::Zero();
  Eigen::Vector2d rays = Eigen::Vector2d::Zero();
  double weights = 0.0;
  double squares = 0.0;
  int count = 0;

  LineStep(const std::vector<const ScanSample*>& samples, const SensorModel& sensor, const Eigen::Vector2d& theta) {
    for (const ScanSample* sample : samples) {
      const double w = theta.dot(sample->ray);
      const double ratio = theta.dot(sample->t);
      if (!(ratio > kNearestSample && ratio < kFarthestSample)) continue;
      const double weight = 1.0 / (sensor.varianceZ(1.0 / w) * (w * w) * (w * w));
      const double rho = w * (1.0 - ratio);
      information += weight * sample->ray * sample->ray.transpose();
      gradient += weight * rho * sample->ray;
      rays += weight * sample->ray;
      weights += weight;
      squares += weight * rho * rho;
      ++count;
    }
  }
};

}  // namespace

void SegmentFitter::setStride(int stride) {
  correlation_ = autocorrelation(error_, stride);
}

void SegmentFitter::fit(const std::vector<const ScanSample*>& samples, LineSegment& segment) {
  residuals_.emplace_back();
  segment.theta_covariance.setZero();
  const Eigen::Vector2d normal = smallestEigenvector(Eigen::Matrix2d(segment.covariance));
  const double distance = normal.dot(Eigen::Vector2d(segment.mean));
  if (!(std::abs(distance) > 1e-9 * segment.mean.norm())) return;  // a line of sight
  Eigen::Vector2d theta = normal / distance;
  segment.theta = theta;

  const LineStep sums(samples, sensor_, theta);
  if (sums.count < 3 || !(sums.information.determinant() > 0.0)) return;
  // The change of theta that moves the inverse depth by 1 all along the segment, and the one that turns it about its
  // middle: they are estimated independently of each other.
  const Eigen::Vector2d offset = sums.information.inverse() * sums.rays;
  const Eigen::Vector2d slope(-sums.rays.y(), sums.rays.x());
  const double of_offset = sums.rays.dot(offset), of_slope = slope.dot(sums.information * slope);
  const double step = offset.dot(sums.gradient) / of_offset, turn = slope.dot(sums.gradient) / of_slope;
  const double change = std::abs(step) + std::abs(turn) * std::sqrt(3.0 * of_slope / sums.weights);
  if (!(change <= kLargestLineStep * std::abs(theta.dot(sums.rays)) / sums.weights)) return;
  theta += step * offset + turn * slope;
  segment.theta = theta;

  const LineSamplesPerIndependent worth =
      lineSamplesPerIndependent(correlation_, sums.count, samples.back()->position - samples.front()->position + 1);
  segment.theta_covariance =
      worth.offset / of_offset * offset * offset.transpose() + worth.slope / of_slope * slope * slope.transpose();
  residuals_.back().squares = std::max(0.0, sums.squares - step * step * of_offset - turn * turn * of_slope);
  residuals_.back().freedom = std::max(0.0, sums.count - worth.offset - worth.slope);
  residuals_.back().independent = std::max(0.0, sums.count / worth.square - 2.0);
}

double SegmentFitter::frameUnit(const LineSegment* segments) const {
  Residuals of_planes, of_all;
  for (std::size_t i = 0; i < residuals_.size(); ++i)
    for (Residuals* sum : {&of_all, &of_planes}) {
      if (sum == &of_planes && segments[i].label == 0) continue;
      sum->squares += residuals_[i].squares;
      sum->freedom += residuals_[i].freedom;
    }
  const Residuals& sum = of_planes.freedom > 0.0 ? of_planes : of_all;
  return sum.freedom > 0.0 ? sum.squares / sum.freedom : 1.0;
}

void SegmentFitter::finish(LineSegment* segments) const {
  const double frame = frameUnit(segments);
  for (std::size_t i = 0; i < residuals_.size(); ++i) {
    const Residuals& own = residuals_[i];
    const double mean_square = own.freedom > 0.0 ? own.squares / own.freedom : 0.0;
    segments[i].theta_covariance *=
        (own.independent * mean_square + kWorthOfFrame * frame) / (own.independent + kWorthOfFrame);
  }
}

}  // namespace epcc
