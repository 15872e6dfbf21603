// SPDX-License-Identifier: BSD-3-Clause
// One pose a line; what is wrong with a line is told with its number.
#include "datasets/files/trajectory_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "datasets/files/text_lines.h"
#include "datasets/support/atomic_file.h"
#include "datasets/support/input_error.h"
#include "datasets/support/number_text.h"

namespace epcc {
namespace {

constexpr std::size_t kNumbers = 8;
constexpr double kLengthTolerance = 0.01;                   // of a quaternion: files have three decimals and more
constexpr std::size_t kMaxTrajectoryLine = kNumbers * 330;  // the largest numbers have 309 digits before the point
const char kTrajectoryHeading[] = "# timestamp tx ty tz qx qy qz qw (s; camera to world, metres)\n";

/// Empty, or what is wrong with the line.
std::string readPose(std::string_view line, StampedPose& stamped) {
  const std::vector<std::string_view> words = wordsOf(line);
  if (words.size() != kNumbers)
    return "has " + std::to_string(words.size()) + " words instead of timestamp tx ty tz qx qy qz qw";
  std::array<double, kNumbers> v;
  for (std::size_t i = 0; i < kNumbers; ++i) {
    const std::optional<double> value = numberFrom(words[i]);
    if (!value || !std::isfinite(*value)) return "'" + std::string(words[i].substr(0, 40)) + "' is not a finite number";
    v[i] = *value;
  }
  const Eigen::Quaterniond turn(v[7], v[4], v[5], v[6]);
  if (std::abs(turn.norm() - 1.0) > kLengthTolerance)
    return "the quaternion's length is " + std::to_string(turn.norm()) + ", not 1";
  stamped.time = v[0];
  stamped.pose = Eigen::Translation3d(v[1], v[2], v[3]) * turn.normalized();
  return {};
}

}  // namespace

void checkPoseCount(const std::string& path, long line, std::size_t poses) {
  if (poses > kMaxPoses)
    throw InputError(path, "line " + std::to_string(line), "more poses than " + std::to_string(kMaxPoses));
}

Trajectory readTrajectory(const std::string& path) {
  Trajectory trajectory;
  TextLines lines(path);
  std::string_view line;
  while (lines.next(line)) {
    const std::size_t first = line.find_first_not_of(" \t\r");
    if (first == std::string_view::npos || line[first] == '#') continue;
    const std::string place = "line " + std::to_string(lines.number());
    StampedPose stamped;
    const std::string problem = readPose(line, stamped);
    if (!problem.empty()) throw InputError(path, place, problem);
    if (!trajectory.empty() && stamped.time <= trajectory.back().time)
      throw InputError(path, place,
                       stamped.time < trajectory.back().time ? "its time is before that of the pose above it"
                                                             : "its time is that of the pose above it");
    trajectory.push_back(stamped);
    checkPoseCount(path, lines.number(), trajectory.size());
  }
  if (trajectory.empty()) throw InputError(path, "file", "has no pose");
  return trajectory;
}

std::string trajectoryLine(const StampedPose& stamped) {
  Eigen::Quaterniond turn(stamped.pose.linear());
  turn.normalize();
  if (turn.w() < 0.0) turn.coeffs() = -turn.coeffs();
  const Eigen::Vector3d at = stamped.pose.translation();
  char text[kMaxTrajectoryLine];
  std::snprintf(text, sizeof text, "%.6f %.9f %.9f %.9f %.9f %.9f %.9f %.9f\n", stamped.time, at.x(), at.y(), at.z(),
                turn.x(), turn.y(), turn.z(), turn.w());
  return text;
}

void writeTrajectory(const std::string& path, const Trajectory& trajectory) {
  std::string text = kTrajectoryHeading;
  for (const StampedPose& stamped : trajectory) text += trajectoryLine(stamped);
  writeTextFile(path, text);
}

std::optional<std::size_t> nearestInTime(const Trajectory& trajectory, double time) {
  if (trajectory.empty()) return std::nullopt;
  const auto later = std::lower_bound(trajectory.begin(), trajectory.end(), time,
                                      [](const StampedPose& stamped, double t) { return stamped.time < t; });
  if (later == trajectory.begin()) return 0;
  const auto place = static_cast<std::size_t>(later - trajectory.begin());
  if (later == trajectory.end()) return place - 1;
  return later->time - time < time - (later - 1)->time ? place : place - 1;
}

std::optional<Eigen::Isometry3d> poseAt(const Trajectory& trajectory, double time, double tolerance) {
  const std::optional<std::size_t> nearest = nearestInTime(trajectory, time);
  if (!nearest || std::abs(trajectory[*nearest].time - time) > tolerance) return std::nullopt;
  return trajectory[*nearest].pose;
}

Eigen::Isometry3d poseBetween(const Trajectory& trajectory, double time) {
  if (time <= trajectory.front().time) return trajectory.front().pose;
  if (time >= trajectory.back().time) return trajectory.back().pose;
  const auto later = std::upper_bound(trajectory.begin(), trajectory.end(), time,
                                      [](double t, const StampedPose& stamped) { return t < stamped.time; });
  const StampedPose &from = *(later - 1), &to = *later;
  const double share = (time - from.time) / (to.time - from.time);
  const Eigen::Quaterniond turn =
      Eigen::Quaterniond(from.pose.linear()).slerp(share, Eigen::Quaterniond(to.pose.linear()));
  const Eigen::Vector3d at = (1.0 - share) * from.pose.translation() + share * to.pose.translation();
  return Eigen::Translation3d(at) * turn;
}

}  // namespace epcc
