// SPDX-License-Identifier: BSD-3-Clause
// A rendered room from any place, with the pose it was seen from.
#pragma once

#include "datasets/rendered/scene_renderer.h"
#include "eval/measures/repeatability.h"

namespace epcc::test {

/// A floor, two walls and a box, seen from a place that is given.
inline Scene roomFrom(const CameraPose& pose) {
  Scene scene;
  scene.pose = pose;
  const auto surface = [&scene](const char* name, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                const Eigen::Vector3d& c,
                                const Eigen::Vector3d& d) { scene.addQuad(scene.addSurface(name), a, b, c, d); };
  surface("floor", {-4, -4, 0}, {4, -4, 0}, {4, 3, 0}, {-4, 3, 0});
  surface("back wall", {-4, 3, 0}, {4, 3, 0}, {4, 3, 3}, {-4, 3, 3});
  surface("side wall", {1.5, -4, 0}, {1.5, 3, 0}, {1.5, 3, 3}, {1.5, -4, 3});
  surface("front of a box", {-0.6, 2, 0}, {0.2, 2, 0}, {0.2, 2, 0.8}, {-0.6, 2, 0.8});
  surface("top of a box", {-0.6, 2, 0.8}, {0.2, 2, 0.8}, {0.2, 2.6, 0.8}, {-0.6, 2.6, 0.8});
  return scene;
}

inline PosedView viewFrom(const CameraPose& pose) {
  PosedView view;
  view.camera = {320, 240, 240.0, 240.0, 159.5, 119.5};
  view.depth = renderView(roomFrom(pose), view.camera).depth;
  view.pose.linear() = pose.rotation().transpose();
  view.pose.translation() = pose.position;
  return view;
}

}  // namespace epcc::test
