// SPDX-License-Identifier: BSD-3-Clause
// Trajectories: written and read back, the pose at a time, and every damaged line.
#include "datasets/files/trajectory_file.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/expect_errors.h"
#include "tests/support/temp_folder.h"

namespace epcc::test {
namespace {

const std::string kFirst = "1.0 1 2 3 0 0 0 1\n";

class TrajectoryFile : public TempFolderTest {
 protected:
  void expectDamaged(const std::string& text, const std::string& field, const std::string& words) {
    const std::string file = write("a.txt", text);
    expectInputError([&] { readTrajectory(file); }, file, field, words);
  }
};

StampedPose stamped(double time, double x, double yaw) {
  StampedPose pose;
  pose.time = time;
  pose.pose = Eigen::Translation3d(x, 0.0, 0.0) * Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ());
  return pose;
}

TEST_F(TrajectoryFile, ReadsWhatTheBenchmarkPublishes) {
  const Trajectory read = readTrajectory(write("a.txt",
                                               "# ground truth trajectory\n# timestamp tx ty tz qx qy qz qw\n\n"
                                               "1305031098.6659 1.3563 0.6305 1.6380 0.6132 0.5962 -0.3311 -0.3986\r\n"
                                               "  1305031098.6758\t1.3543 0.6306 1.6360 0 0 0.7071 0.7071\n"));
  ASSERT_EQ(read.size(), 2U);
  EXPECT_DOUBLE_EQ(read[0].time, 1305031098.6659);
  EXPECT_DOUBLE_EQ(read[0].pose.translation().y(), 0.6305);
  EXPECT_TRUE((read[1].pose.linear() * read[1].pose.linear().transpose()).isIdentity(1e-12)) << "made a rotation";
  EXPECT_NEAR((read[1].pose.linear() * Eigen::Vector3d::UnitX()).y(), 1.0, 1e-9) << "qz = qw turns x to y";
}

TEST_F(TrajectoryFile, WritesWhatItReads) {
  const Trajectory made = {stamped(0.0, 1.5, 0.3), stamped(1.0 / 30, -2.0, -3.0)};
  writeTrajectory(path("a.txt"), made);
  const Trajectory read = readTrajectory(path("a.txt"));
  ASSERT_EQ(read.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_NEAR(read[i].time, made[i].time, 1e-6);
    EXPECT_TRUE(read[i].pose.isApprox(made[i].pose, 1e-8));
  }
}

TEST_F(TrajectoryFile, WritesTheLargestNumbersWhole) {
  StampedPose far;
  far.time = 1e300;
  far.pose.translation() = Eigen::Vector3d(-1.5e308, 1e308, -1e307);
  writeTrajectory(path("a.txt"), {stamped(0.0, 0.0, 0.0), far});
  const Trajectory read = readTrajectory(path("a.txt"));
  ASSERT_EQ(read.size(), 2U);
  EXPECT_EQ(read[1].time, far.time);
  EXPECT_EQ(read[1].pose.translation(), far.pose.translation());
}

TEST_F(TrajectoryFile, NamesTheDamagedLine) {
  expectDamaged(kFirst + "2.0 1 2 3 0 0 1\n", "line 2", "7 words");
  expectDamaged(kFirst + "2.0 1 2 3 0 0 0 1 5\n", "line 2", "9 words");
  expectDamaged(kFirst + "2.0 1 2 x 0 0 0 1\n", "line 2", "'x'");
  expectDamaged(kFirst + "2.0 1 2 nan 0 0 0 1\n", "line 2", "'nan'");
  expectDamaged("# c\n" + kFirst + "2.0 1 2 3 0 0 0 1.02\n", "line 3", "quaternion");
  expectDamaged(kFirst + "2.0 1 2 3 0 0 0 0\n", "line 2", "quaternion");
  expectDamaged(kFirst + "0.5 1 2 3 0 0 0 1\n", "line 2", "before");
  expectDamaged(kFirst + kFirst, "line 2", "its time is that of the pose above");
  expectDamaged("# nothing\n", "file", "no pose");
}

TEST(TrajectoryTimes, TakesTheNearestWithinTheTolerance) {
  const Trajectory trajectory = {stamped(1.0, 1.0, 0.0), stamped(2.0, 2.0, 0.0)};
  EXPECT_EQ(poseAt(trajectory, 1.015)->translation().x(), 1.0);
  EXPECT_EQ(poseAt(trajectory, 1.985)->translation().x(), 2.0);
  EXPECT_EQ(poseAt(trajectory, 2.015)->translation().x(), 2.0);
  EXPECT_FALSE(poseAt(trajectory, 1.03));
  EXPECT_FALSE(poseAt(trajectory, 0.97));
  EXPECT_FALSE(poseAt({}, 1.0));
  EXPECT_EQ(poseAt(trajectory, 1.6, 0.5)->translation().x(), 2.0);
  EXPECT_EQ(*nearestInTime(trajectory, 1.5), 0U) << "the earlier of two";
}

TEST(TrajectoryTimes, GoesStraightBetweenPoses) {
  const Trajectory trajectory = {stamped(1.0, 1.0, 0.0), stamped(3.0, 2.0, 1.0)};
  const Eigen::Isometry3d between = poseBetween(trajectory, 1.5);
  EXPECT_NEAR(between.translation().x(), 1.25, 1e-12);
  EXPECT_NEAR(Eigen::AngleAxisd(between.linear()).angle(), 0.25, 1e-12);
  EXPECT_EQ(poseBetween(trajectory, 0.0).translation().x(), 1.0);
  EXPECT_EQ(poseBetween(trajectory, 9.0).translation().x(), 2.0);
}

}  // namespace
}  // namespace epcc::test
