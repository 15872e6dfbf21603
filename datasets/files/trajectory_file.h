// SPDX-License-Identifier: BSD-3-Clause
// Trajectories as text, in the format of the TUM RGB-D benchmark: where a camera was, and when.
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace epcc {

/// Where a camera was at a time.
struct StampedPose {
  double time = 0.0;                                       ///< s
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();  ///< camera to world, metres
};

/// In the order of time, no time twice.
using Trajectory = std::vector<StampedPose>;

/// Largest difference of two times that belong to each other, seconds: that of TUM's associate.py.
constexpr double kMaxTimeDifference = 0.02;

/// Poses that are read at most: those of a camera with 30 frames a second in 92 hours.
constexpr std::size_t kMaxPoses = 10U * 1000 * 1000;

/// InputError, at a line of a file, if there are more poses than these so far: a packed file of a few megabytes may
/// have them.
void checkPoseCount(const std::string& path, long line, std::size_t poses);

/// Lines `timestamp tx ty tz qx qy qz qw`, and comments that start with #; packed by gzip or not. InputError naming
/// file and line: a line with fewer or more numbers, one that is not finite, a quaternion whose length is not 1 (to a
/// hundredth, then it is made 1), a time that is not later than the one before, no pose at all.
Trajectory readTrajectory(const std::string& path);

/// One line of the file, with its end: times with six decimals, metres and quaternions with nine.
std::string trajectoryLine(const StampedPose& stamped);

/// Writes them in the order given, whole or not at all. OutputError on failure.
void writeTrajectory(const std::string& path, const Trajectory& trajectory);

/// The place in the trajectory whose time is nearest, the earlier of two; nothing if it is empty.
std::optional<std::size_t> nearestInTime(const Trajectory& trajectory, double time);

/// The pose whose time is nearest, if it is not more than `tolerance` seconds away.
std::optional<Eigen::Isometry3d> poseAt(const Trajectory& trajectory, double time,
                                        double tolerance = kMaxTimeDifference);

/// The pose at a time between two of the trajectory, on the straight way and by an even turn; the first before its
/// start, the last behind its end. Not for an empty trajectory.
Eigen::Isometry3d poseBetween(const Trajectory& trajectory, double time);

}  // namespace epcc
