// SPDX-License-Identifier: BSD-3-Clause
// Ranges of the parameters, and poses that are none.
#include "over_time/tracker_checks.h"

#include <Eigen/Geometry>
#include <cmath>

namespace epcc {

namespace {

constexpr double kRotationTolerance = 1e-3;
constexpr double kFarthestCamera = 1e9;  // metres: beyond, nothing of a frame is left in the map's digits

std::string sigmaProblem(const char* name, double value, double largest, const char* unit) {
  if (value > 0.0 && value <= largest) return {};
  return std::string(name) + " must be above 0 and at most " + std::to_string(static_cast<int>(largest)) + " " + unit;
}

std::string countProblem(const char* name, int value) {
  if (value >= 1 && value <= 1000) return {};
  return std::string(name) + " must be from 1 to 1000 frames";
}

std::string poseProblem(const Isometry3& pose) {
  const Eigen::Isometry3d camera(pose);
  if (!camera.matrix().allFinite()) return "the pose holds a number that is not finite";
  if (camera.translation().cwiseAbs().maxCoeff() > kFarthestCamera)
    return "the pose is more than a million kilometres from the origin of the map";
  const Eigen::Matrix3d turn = camera.linear();
  const double deviation = (turn * turn.transpose() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
  if (deviation > kRotationTolerance || turn.determinant() < 0.0) return "the pose has no rotation";
  return {};
}

}  // namespace

std::string TrackerParameters::validate() const {
  for (const std::string& problem :
       {sigmaProblem("pose_offset_sigma", pose_offset_sigma, 10.0, "m"),
        sigmaProblem("pose_angle_sigma", pose_angle_sigma, 1.0, "rad"),
        sigmaProblem("motion_offset_sigma", motion_offset_sigma, 10.0, "m"),
        sigmaProblem("motion_angle_sigma", motion_angle_sigma, 1.0, "rad"),
        countProblem("confirm_frames", confirm_frames), countProblem("search_frames", search_frames),
        countProblem("memory_frames", memory_frames)})
    if (!problem.empty()) return problem;
  return {};
}

std::string trackerProblem(const TrackerParameters& parameters, const std::optional<Isometry3>& camera_to_map,
                           double time) {
  std::string problem = parameters.validate();
  if (problem.empty() && !std::isfinite(time)) problem = "the time is not finite";
  if (problem.empty() && camera_to_map) problem = poseProblem(*camera_to_map);
  return problem;
}

}  // namespace epcc
