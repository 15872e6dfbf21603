// SPDX-License-Identifier: BSD-3-Clause
// What a rendered scene is made of: convex polygons, spheres and cylinders in a world frame, and a camera pose.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace epcc {

/// Surface index of everything that is not a plane to be found.
constexpr int kClutter = -1;

/// Convex planar polygon, vertices in order, metres.
struct ScenePolygon {
  std::vector<Eigen::Vector3d> vertices;
  int surface = kClutter;  ///< index into Scene::surfaces
};

/// Closed cylinder from `base` to `top`, metres; clutter.
struct SceneCylinder {
  Eigen::Vector3d base;
  Eigen::Vector3d top;
  double radius = 0.0;
};

/// Clutter.
struct SceneSphere {
  Eigen::Vector3d center;
  double radius = 0.0;
};

/// Where the camera stands. World frame: x right, y forward, z up, metres.
struct CameraPose {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  double yaw = 0.0;    ///< radians, to the left
  double pitch = 0.0;  ///< radians, downwards
  double roll = 0.0;   ///< radians, clockwise as seen from behind the camera

  /// World -> camera frame (x right, y down, z forward).
  Eigen::Matrix3d rotation() const;
  Eigen::Vector3d toCamera(const Eigen::Vector3d& world) const { return rotation() * (world - position); }
};

/// Upright box: centre of its bottom face, size along its own axes, turned about the vertical by `yaw` radians.
struct SceneBox {
  Eigen::Vector3d bottom;
  Eigen::Vector3d size;
  double yaw = 0.0;
};

/// Everything in front of the camera. Several polygons may belong to one surface if they lie in one plane.
struct Scene {
  std::vector<std::string> surfaces;  ///< names; labels are index + 1
  std::vector<ScenePolygon> polygons;
  /// Faces of boxes that are turned away from `pose`, for other poses: surface and name, see showAllSides().
  std::vector<ScenePolygon> turned_away;
  std::vector<std::string> turned_away_names;
  std::vector<SceneCylinder> cylinders;
  std::vector<SceneSphere> spheres;
  CameraPose pose;

  /// New planar surface, its index.
  int addSurface(const std::string& name);
  void addQuad(int surface, const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
               const Eigen::Vector3d& d);
  /// A box whose faces are surfaces, but for those turned away from the camera; set the pose before.
  void addBox(const std::string& name, const SceneBox& box);
  /// Makes the faces that are turned away surfaces, too, numbered behind the others, for a camera that goes round. What
  /// boxes stand on is no surface.
  void showAllSides();
  /// A box that counts as clutter.
  void addClutterBox(const SceneBox& box);
  /// A chair of thin boxes and round legs, on the ground at `ground`, turned by `yaw` radians: clutter.
  void addChair(const Eigen::Vector3d& ground, double yaw);
};

}  // namespace epcc
