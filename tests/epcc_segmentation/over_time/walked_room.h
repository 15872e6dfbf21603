// SPDX-License-Identifier: BSD-3-Clause
// The corner of a room, as a camera sees it that moves through it.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <vector>

#include "over_time/plane_motion.h"
#include "tests/support/rendered_room.h"

namespace epcc::test {

inline const SensorModel kRoomSensor = SensorModel::axial(0.0005, 0.001, 0.0);

/// Along a gentle curve, looking about.
inline Eigen::Isometry3d cameraAt(int frame) {
  const double t = 0.05 * frame;
  Eigen::Isometry3d camera = Eigen::Isometry3d::Identity();
  camera.linear() = (Eigen::AngleAxisd(0.15 * std::sin(t), Eigen::Vector3d::UnitY()) *
                     Eigen::AngleAxisd(0.08 * std::sin(0.7 * t), Eigen::Vector3d::UnitX()))
                        .toRotationMatrix();
  camera.translation() << 0.2 * std::sin(0.9 * t), 0.05 * std::sin(1.3 * t), 0.15 * (1.0 - std::cos(t));
  return camera;
}

/// What the camera sees of the corner of a room, with error.
inline RenderedRoom roomFrom(const Eigen::Isometry3d& camera, unsigned seed) {
  std::vector<Eigen::Vector4d> planes;
  for (const Eigen::Vector4d& plane : cornerPlanes()) planes.push_back(planeSeenFrom(camera, plane));
  RenderedRoom room = renderRoom(planes, testCamera());
  addNoise(room, kRoomSensor, seed);
  return room;
}

}  // namespace epcc::test
