// SPDX-License-Identifier: BSD-3-Clause
// Cameras are mostly held level, and rooms have floors.
#include "eval/track/map_view.h"

#include <cmath>

#include "datasets/support/degree.h"

namespace epcc {
namespace {

constexpr double kFloorTilt = 30.0 * kDegree;
constexpr double kLookDown = 40.0 * kDegree;
constexpr double kFromOneSide = 25.0 * kDegree;

Eigen::Vector3d meanAxis(const Trajectory& trajectory, int axis) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const StampedPose& stamped : trajectory) sum += stamped.pose.linear().col(axis);
  return sum;
}

/// A horizontal unit vector along `wanted`, or any.
Eigen::Vector3d level(const Eigen::Vector3d& wanted, const Eigen::Vector3d& up) {
  const Eigen::Vector3d flat = wanted - up * up.dot(wanted);
  return flat.norm() > 1e-3 * wanted.norm() && flat.norm() > 0.0 ? flat.normalized() : up.unitOrthogonal();
}

}  // namespace

Eigen::Vector3d upwards(const std::vector<MappedTrack>& tracks, const Trajectory& trajectory) {
  const Eigen::Vector3d mean = -meanAxis(trajectory, 1);
  const Eigen::Vector3d up =
      mean.norm() > 1e-6 ? Eigen::Vector3d(mean.normalized()) : Eigen::Vector3d(-Eigen::Vector3d::UnitY());
  const MappedTrack* best = nullptr;
  for (const MappedTrack& one : tracks) {
    if (one.track.end != TrackEnd::None || (best != nullptr && one.surface.area <= best->surface.area)) continue;
    if (std::abs(up.dot(one.track.plane.coefficients.head<3>())) > std::cos(kFloorTilt)) best = &one;
  }
  if (best == nullptr) return up;
  const Eigen::Vector3d normal = best->track.plane.coefficients.head<3>();
  return normal.dot(up) > 0.0 ? normal : Eigen::Vector3d(-normal);
}

MapView viewFromAbove(const Eigen::Vector3d& up, const Trajectory& trajectory) {
  MapView view;
  view.out = up;
  view.up = level(meanAxis(trajectory, 2), up);
  view.right = view.up.cross(view.out);
  return view;
}

MapView obliqueView(const Eigen::Vector3d& up, const Trajectory& trajectory) {
  const Eigen::Vector3d ahead = Eigen::AngleAxisd(kFromOneSide, up) * level(meanAxis(trajectory, 2), up);
  MapView view;
  view.out = std::sin(kLookDown) * up - std::cos(kLookDown) * ahead;
  view.up = std::cos(kLookDown) * up + std::sin(kLookDown) * ahead;
  view.right = view.up.cross(view.out);
  return view;
}

}  // namespace epcc
