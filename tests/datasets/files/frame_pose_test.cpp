// SPDX-License-Identifier: BSD-3-Clause
// The pose of a frame, and what is no pose.
#include "datasets/files/frame_pose.h"

#include <gtest/gtest.h>

#include "tests/support/expect_errors.h"

namespace epcc::test {
namespace {

LabelledFrame frameWith(const nlohmann::json& pose) {
  LabelledFrame frame;
  frame.name = "room";
  frame.camera.extra = {{"pose", pose}};
  return frame;
}

void expectRefused(const nlohmann::json& pose, const std::string& words) {
  expectInputError([&] { framePose(frameWith(pose)); }, "room.json", "pose", words);
}

TEST(FramePose, RowsComeOneAfterTheOtherOrAsRows) {
  for (const nlohmann::json& pose : {nlohmann::json{0, 0, 1, 4, -1, 0, 0, 5, 0, -1, 0, 6},
                                     nlohmann::json{{0, 0, 1, 4}, {-1, 0, 0, 5}, {0, -1, 0, 6}}}) {
    const auto read = framePose(frameWith(pose));
    ASSERT_TRUE(read.has_value());
    EXPECT_EQ(*read * Eigen::Vector3d(1, 2, 3), Eigen::Vector3d(7, 4, 4)) << "camera to world";
  }
}

TEST(FramePose, FramesWithoutOneHaveNone) {
  EXPECT_FALSE(framePose(LabelledFrame()).has_value());
  EXPECT_FALSE(framePose(frameWith(nullptr)).has_value());
}

TEST(FramePose, WhatIsWrittenIsRead) {
  Eigen::Isometry3d pose(Eigen::AngleAxisd(0.3, Eigen::Vector3d(1, 2, 2).normalized()));
  pose.translation() << -1.5, 0.25, 8.0;
  LabelledFrame frame = frameWith(nullptr);
  setFramePose(pose, frame);
  EXPECT_TRUE(framePose(frame)->isApprox(pose, 1e-15));
}

TEST(FramePose, WhatIsNoPoseIsAnError) {
  expectRefused("north", "12 numbers");
  expectRefused({1, 0, 0}, "12 numbers");
  expectRefused({{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1}}, "12 numbers");
  expectRefused({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, "1", 0}, "not a number");
  expectRefused({2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0}, "no rotation");
  expectRefused({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0}, "no rotation");
  expectRefused({0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, "no rotation");
  expectRefused({1, 0, 0, std::numeric_limits<double>::infinity(), 0, 1, 0, 0, 0, 0, 1, 0}, "not finite");
}

}  // namespace
}  // namespace epcc::test
