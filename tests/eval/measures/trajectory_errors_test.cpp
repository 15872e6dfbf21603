// SPDX-License-Identifier: BSD-3-Clause
// Errors of trajectories whose error is known.
#include "eval/measures/trajectory_errors.h"

#include <gtest/gtest.h>

#include <cmath>

namespace epcc::test {
namespace {

Eigen::Isometry3d pose(double x, double y, double yaw) {
  return Eigen::Translation3d(x, y, 0.0) * Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ());
}

/// Ten poses a second on a curve.
Trajectory curve() {
  Trajectory trajectory;
  for (int i = 0; i < 41; ++i) trajectory.push_back({0.1 * i, pose(0.2 * i, std::sin(0.3 * i), 0.05 * i)});
  return trajectory;
}

TEST(ErrorStatistics, OfAFewNumbers) {
  const ErrorStatistics result = errorStatistics({1.0, 2.0, 6.0, 3.0});
  EXPECT_EQ(result.count, 4U);
  EXPECT_DOUBLE_EQ(result.mean, 3.0);
  EXPECT_DOUBLE_EQ(result.median, 2.5);
  EXPECT_DOUBLE_EQ(result.max, 6.0);
  EXPECT_DOUBLE_EQ(result.rmse, std::sqrt(12.5));
  EXPECT_EQ(errorStatistics({}).count, 0U);
}

TEST(TrajectoryErrors, AnotherWorldIsNoError) {
  const Trajectory truth = curve();
  Trajectory moved = truth;
  for (StampedPose& stamped : moved) stamped.pose = pose(5.0, -3.0, 2.0) * stamped.pose;
  EXPECT_LT(relativePoseErrors(moved, truth).metres.max, 1e-12);
  EXPECT_LT(relativePoseErrors(moved, truth).degrees.max, 1e-5);
  EXPECT_LT(absoluteTrajectoryErrors(moved, truth).max, 1e-12);
}

TEST(TrajectoryErrors, ASteadyDriftShowsInEachSecond) {
  const Trajectory truth = curve();
  Trajectory drifting = truth;
  for (StampedPose& stamped : drifting) stamped.pose = stamped.pose * pose(0.0, 0.0, 0.01 * stamped.time);
  const RelativePoseErrors errors = relativePoseErrors(drifting, truth, 1.0);
  // From 0 to 2.9 s: one that would end at the last pose, or be cut short by it, does not count.
  EXPECT_EQ(errors.degrees.count, 30U);
  EXPECT_NEAR(errors.degrees.median, 0.01 * 180.0 / M_PI, 1e-6);
  EXPECT_NEAR(errors.degrees.max, 0.01 * 180.0 / M_PI, 1e-6);
}

TEST(TrajectoryErrors, OneShiftedPoseAmongMany) {
  const Trajectory truth = curve();
  Trajectory shifted = truth;
  shifted[5].pose.translation().z() += 0.1;
  const RelativePoseErrors errors = relativePoseErrors(shifted, truth, 1.0);
  EXPECT_NEAR(errors.metres.max, 0.1, 1e-12);
  EXPECT_NEAR(errors.metres.mean * static_cast<double>(errors.metres.count), 0.1, 1e-9) << "no pose ends at the sixth";
  const ErrorStatistics absolute = absoluteTrajectoryErrors(shifted, truth);
  EXPECT_EQ(absolute.count, 41U);
  EXPECT_GT(absolute.max, 0.09);
  EXPECT_LT(absolute.max, 0.1) << "the alignment gives way a little";
}

TEST(TrajectoryErrors, ScaleIsAnError) {
  const Trajectory truth = curve();
  Trajectory large = truth;
  for (StampedPose& stamped : large) stamped.pose.translation() *= 1.1;
  EXPECT_GT(absoluteTrajectoryErrors(large, truth).rmse, 0.1);
}

TEST(TrajectoryErrors, TruthWithinTwoIntervalsIsGoodEnough) {
  Trajectory late = curve();
  for (StampedPose& stamped : late) stamped.time += 0.049;
  EXPECT_EQ(relativePoseErrors(late, curve(), 1.0).metres.count, 30U);
  for (StampedPose& stamped : late) stamped.time += 3.8;
  EXPECT_EQ(relativePoseErrors(late, curve(), 1.0).metres.count, 0U) << "none has the truth at both ends";
}

TEST(TrajectoryErrors, PosesWithoutTruthAreLeftOut) {
  Trajectory late = curve();
  for (StampedPose& stamped : late) stamped.time += 10.0;
  EXPECT_EQ(relativePoseErrors(late, curve()).metres.count, 0U);
  EXPECT_EQ(absoluteTrajectoryErrors(late, curve()).count, 0U);
  late = curve();
  for (StampedPose& stamped : late) stamped.time += 0.019;
  EXPECT_EQ(absoluteTrajectoryErrors(late, curve()).count, 41U);
  EXPECT_EQ(absoluteTrajectoryErrors({}, curve()).count, 0U);
  EXPECT_EQ(relativePoseErrors({}, curve()).metres.count, 0U);
}

}  // namespace
}  // namespace epcc::test
