// SPDX-License-Identifier: BSD-3-Clause
// From where a scene is looked at, and which point lies under the mouse.
#pragma once

#include <Eigen/Core>

#include "eval/view/view_scene.h"

namespace epcc {

/// A perspective view. `up` need not be perpendicular to the view.
struct ViewCamera {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Vector3d target = Eigen::Vector3d::UnitZ();  ///< what is in the middle of the picture
  Eigen::Vector3d up = -Eigen::Vector3d::UnitY();
  double angle = 30.0;  ///< from the lower to the upper edge, degrees
};

enum class ViewPlace {
  Sensor,   ///< from where the sensor is
  Slanted,  ///< from behind and above it
  Top       ///< from above
};

/// The first place to show a scene from: Sensor, but Slanted for a scanner, which is in the middle of what it sees.
ViewPlace firstPlace(const ViewScene& scene);

/// The view from there, such that the points but a few far ones are in a picture that is `aspect` times as wide as
/// high. A scene without points is looked at from its sensor.
ViewCamera viewFrom(ViewPlace place, const ViewScene& scene, double aspect);

/// Pixel (x to the right, y down) of a point in a picture of this size; false if it lies behind the camera. `distance`
/// is measured along the camera's axis.
bool projectPoint(const ViewCamera& camera, int width, int height, const Eigen::Vector3d& point, Eigen::Vector2d& pixel,
                  double& distance);

/// The nearest point of those within four pixels of (x, y); -1 if there is none.
int pointAt(const ViewScene& scene, const ViewCamera& camera, int width, int height, double x, double y);

}  // namespace epcc
