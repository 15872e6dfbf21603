// SPDX-License-Identifier: BSD-3-Clause
// Casts one ray a pixel at a scene: exact depth, surface index and plane coefficients.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <vector>

#include "datasets/files/image.h"
#include "datasets/rendered/scene_geometry.h"
#include "epcc_segmentation/depth_frame.h"

namespace epcc {

/// What the camera sees of a scene, free of noise.
struct SceneView {
  DepthImage depth;                     ///< metres along the optical axis, 0 where the ray leaves the scene
  Image<int> surface;                   ///< index into Scene::surfaces or kClutter
  std::vector<Eigen::Vector4d> planes;  ///< (a, b, c, d) of each surface in the camera frame, d > 0
};

SceneView renderView(const Scene& scene, const PinholeCamera& camera);
/// The same from another place than the scene's own pose.
SceneView renderView(const Scene& scene, const PinholeCamera& camera, const Eigen::Isometry3d& camera_to_world);

/// Eq. 10: the depth of an unbounded plane (a, b, c, d) in the camera frame, 0 where it is not in front of the camera.
DepthImage renderPlane(const Eigen::Vector4d& plane, const PinholeCamera& camera);

}  // namespace epcc
