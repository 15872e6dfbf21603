// SPDX-License-Identifier: BSD-3-Clause
// Rendered views whose relative pose is known are aligned from starts that are off.
#include "eval/measures/depth_alignment.h"

#include <gtest/gtest.h>

#include <random>
#include <stdexcept>

#include "eval/measures/trajectory_errors.h"
#include "tests/eval/measures/posed_room.h"

namespace epcc::test {
namespace {

const SensorModel kKinect = SensorModel::axial(0.0, 0.0014);

Eigen::Isometry3d aside(double metres, double degrees) {
  return Eigen::Translation3d(metres * Eigen::Vector3d(2.0, -1.0, 2.0) / 3.0) *
         Eigen::AngleAxisd(degrees * M_PI / 180.0, Eigen::Vector3d(1.0, 2.0, -2.0) / 3.0);
}

void addNoise(PosedView& view, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  for (float& depth : view.depth.data)
    if (depth > 0.0F) depth += static_cast<float>(kKinect.sigmaZ(depth) * normal(random));
}

struct Pair {
  PosedView from = viewFrom({{0.0, 0.0, 1.4}, 0.0, 0.25, 0.0});
  PosedView to = viewFrom({{-0.2, 0.15, 1.45}, -0.12, 0.3, 0.05});
  Eigen::Isometry3d truth = to.pose.inverse() * from.pose;
};

TEST(DepthAlignment, FindsThePoseOfNoisyViews) {
  Pair pair;
  addNoise(pair.from, 1);
  addNoise(pair.to, 2);
  const Eigen::Isometry3d start = aside(0.05, 2.0) * pair.truth;
  const PoseDifference before = poseDifference(start, pair.truth);
  EXPECT_NEAR(before.metres, 0.05, 1e-9);
  EXPECT_NEAR(before.degrees, 2.0, 1e-9);
  const DepthAlignment found = alignDepth(pair.from, pair.to, kKinect, {start});
  const PoseDifference error = poseDifference(found.to_from, pair.truth);
  EXPECT_LT(error.metres, 0.002);
  EXPECT_LT(error.degrees, 0.1);
  EXPECT_LE(found.misfit, depthMisfit(pair.from, pair.to, kKinect, pair.truth));
  EXPECT_EQ(found.misfit, depthMisfit(pair.from, pair.to, kKinect, found.to_from));
  EXPECT_GT(depthMisfit(pair.from, pair.to, kKinect, start), 2.0 * found.misfit);
}

TEST(DepthAlignment, NoStartIsFavoured) {
  const Pair pair;
  const Eigen::Isometry3d near = aside(0.02, 0.5) * pair.truth, far = aside(1.2, 40.0) * pair.truth;
  const DepthAlignment best = alignDepth(pair.from, pair.to, kKinect, {near, far});
  EXPECT_LT(poseDifference(best.to_from, pair.truth).metres, 0.002);
  EXPECT_EQ(best.misfit, alignDepth(pair.from, pair.to, kKinect, {far, near}).misfit);
  EXPECT_LT(best.misfit, alignDepth(pair.from, pair.to, kKinect, {far}).misfit);
}

TEST(DepthAlignment, GivenPosesThatAreWrongAreNotFollowed) {
  Pair pair;
  pair.to.pose = pair.to.pose * aside(0.04, 1.5);  // what a trajectory says; the images know better
  const DepthAlignment found = alignDepth(pair.from, pair.to, kKinect, {pair.to.pose.inverse() * pair.from.pose});
  EXPECT_LT(poseDifference(found.to_from, pair.truth).metres, 0.002);
}

TEST(DepthAlignment, NoiseAloneIsAMisfitBelowOne) {
  Pair pair;
  PosedView again = pair.from;
  addNoise(pair.from, 1);
  addNoise(again, 2);
  const double misfit = depthMisfit(pair.from, again, kKinect, Eigen::Isometry3d::Identity());
  EXPECT_GT(misfit, 0.5);
  EXPECT_LT(misfit, 1.0);
}

TEST(DepthAlignment, WhatASingleWallLeavesOpenStays) {
  PosedView wall;
  wall.camera = {160, 120, 120.0, 120.0, 79.5, 59.5};
  wall.depth = DepthImage(160, 120, 2.0F);
  const Eigen::Isometry3d start(Eigen::Translation3d(0.03, -0.02, 0.05));
  const DepthAlignment found = alignDepth(wall, wall, kKinect, {start});
  EXPECT_NEAR(found.to_from.translation().z(), 0.0, 0.001);
  EXPECT_NEAR(found.to_from.translation().x(), 0.03, 0.002);
  EXPECT_NEAR(found.to_from.translation().y(), -0.02, 0.002);
}

TEST(DepthAlignment, ViewsThatShowNothingInCommonStayWhereTheyAre) {
  const Pair pair;
  PosedView nothing = pair.to;
  nothing.depth = DepthImage(320, 240, 0.0F);
  EXPECT_LT(poseDifference(alignDepth(pair.from, nothing, kKinect, {pair.truth}).to_from, pair.truth).metres, 1e-9);
  EXPECT_LT(poseDifference(alignDepth(nothing, pair.to, kKinect, {pair.truth}).to_from, pair.truth).metres, 1e-9);
  EXPECT_THROW(alignDepth(pair.from, pair.to, kKinect, {}), std::invalid_argument);
}

}  // namespace
}  // namespace epcc::test
