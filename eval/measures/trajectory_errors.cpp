// SPDX-License-Identifier: BSD-3-Clause
// Poses are paired by time, then compared.
#include "eval/measures/trajectory_errors.h"

#include <algorithm>
#include <cmath>

#include "datasets/support/quantile.h"

namespace epcc {
namespace {

double medianInterval(const Trajectory& trajectory) {
  std::vector<double> intervals;
  for (std::size_t i = 1; i < trajectory.size(); ++i) intervals.push_back(trajectory[i].time - trajectory[i - 1].time);
  return median(std::move(intervals));
}

}  // namespace

PoseDifference poseDifference(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b) {
  const Eigen::Isometry3d error = a * b.inverse();
  return {error.translation().norm(), Eigen::AngleAxisd(error.linear()).angle() * 180.0 / M_PI};
}

ErrorStatistics errorStatistics(const std::vector<double>& errors) {
  ErrorStatistics result;
  if (errors.empty()) return result;
  result.count = errors.size();
  double sum = 0.0, squares = 0.0;
  for (const double error : errors) {
    sum += error;
    squares += error * error;
    result.max = std::max(result.max, error);
  }
  const auto count = static_cast<double>(errors.size());
  result.mean = sum / count;
  result.rmse = std::sqrt(squares / count);
  result.median = median(errors);
  return result;
}

RelativePoseErrors relativePoseErrors(const Trajectory& estimate, const Trajectory& truth, double seconds,
                                      const std::vector<bool>& counts) {
  const double tolerance = 2.0 * medianInterval(truth);
  std::vector<double> metres, degrees;
  for (std::size_t i = 0; i < estimate.size(); ++i) {
    const StampedPose& from = estimate[i];
    const std::size_t place = *nearestInTime(estimate, from.time + seconds);
    if (place + 1 == estimate.size() || (!counts.empty() && !(counts[i] && counts[place]))) continue;
    const StampedPose& to = estimate[place];
    const auto true_from = poseAt(truth, from.time, tolerance), true_to = poseAt(truth, to.time, tolerance);
    if (!true_from || !true_to) continue;
    const PoseDifference error = poseDifference(from.pose.inverse() * to.pose, true_from->inverse() * *true_to);
    metres.push_back(error.metres);
    degrees.push_back(error.degrees);
  }
  return {errorStatistics(metres), errorStatistics(degrees)};
}

ErrorStatistics absoluteTrajectoryErrors(const Trajectory& estimate, const Trajectory& truth, double tolerance) {
  Eigen::Matrix3Xd from(3, static_cast<Eigen::Index>(estimate.size())), to = from;
  Eigen::Index count = 0;
  for (const StampedPose& stamped : estimate) {
    const auto true_pose = poseAt(truth, stamped.time, tolerance);
    if (!true_pose) continue;
    from.col(count) = stamped.pose.translation();
    to.col(count++) = true_pose->translation();
  }
  if (count < 3) return {};
  from.conservativeResize(3, count);
  to.conservativeResize(3, count);
  const Eigen::Isometry3d laid(Eigen::umeyama(from, to, false));
  std::vector<double> errors;
  for (Eigen::Index i = 0; i < count; ++i)
    errors.push_back((laid * Eigen::Vector3d(from.col(i)) - Eigen::Vector3d(to.col(i))).norm());
  return errorStatistics(errors);
}

}  // namespace epcc
