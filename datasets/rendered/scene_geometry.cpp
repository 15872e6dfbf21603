// SPDX-License-Identifier: BSD-3-Clause
// Builds boxes and chairs from polygons and cylinders.
#include "datasets/rendered/scene_geometry.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>

namespace epcc {
namespace {

using Eigen::Vector3d;

// Point of the box at fractions (x, y in -1..1, z in 0..1) of its size.
Vector3d boxPoint(const SceneBox& box, double x, double y, double z) {
  const double px = 0.5 * x * box.size.x(), py = 0.5 * y * box.size.y();
  const double c = std::cos(box.yaw), s = std::sin(box.yaw);
  return box.bottom + Vector3d(c * px - s * py, s * px + c * py, z * box.size.z());
}

struct BoxFace {
  const char* name;
  std::array<std::array<double, 3>, 4> corners;  // fractions, counter-clockwise from outside
};

constexpr std::array<BoxFace, 6> kFaces = {{
    {"front", {{{-1, -1, 0}, {1, -1, 0}, {1, -1, 1}, {-1, -1, 1}}}},
    {"right", {{{1, -1, 0}, {1, 1, 0}, {1, 1, 1}, {1, -1, 1}}}},
    {"back", {{{1, 1, 0}, {-1, 1, 0}, {-1, 1, 1}, {1, 1, 1}}}},
    {"left", {{{-1, 1, 0}, {-1, -1, 0}, {-1, -1, 1}, {-1, 1, 1}}}},
    {"top", {{{-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}}}},
    {"bottom", {{{-1, 1, 0}, {1, 1, 0}, {1, -1, 0}, {-1, -1, 0}}}},
}};

ScenePolygon facePolygon(const SceneBox& box, const BoxFace& face) {
  ScenePolygon polygon;
  for (const auto& corner : face.corners) polygon.vertices.push_back(boxPoint(box, corner[0], corner[1], corner[2]));
  return polygon;
}

bool facesPoint(const ScenePolygon& polygon, const Vector3d& point) {
  const auto& v = polygon.vertices;
  return (v[1] - v[0]).cross(v[2] - v[0]).dot(point - v[0]) > 0.0;
}

}  // namespace

Eigen::Matrix3d CameraPose::rotation() const {
  Eigen::Matrix3d level;  // rows: the camera's right, down and forward axes in the world
  level << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  const Eigen::Matrix3d turned = Eigen::AngleAxisd(-yaw, Vector3d::UnitZ()).toRotationMatrix();
  const Eigen::Matrix3d tilted = Eigen::AngleAxisd(pitch, Vector3d::UnitX()).toRotationMatrix();
  const Eigen::Matrix3d rolled = Eigen::AngleAxisd(-roll, Vector3d::UnitZ()).toRotationMatrix();
  return rolled * tilted * level * turned;
}

int Scene::addSurface(const std::string& name) {
  surfaces.push_back(name);
  return static_cast<int>(surfaces.size()) - 1;
}

void Scene::addQuad(int surface, const Vector3d& a, const Vector3d& b, const Vector3d& c, const Vector3d& d) {
  polygons.push_back({{a, b, c, d}, surface});
}

void Scene::addBox(const std::string& name, const SceneBox& box) {
  for (const BoxFace& face : kFaces) {
    ScenePolygon polygon = facePolygon(box, face);
    const std::string full_name = name + ' ' + face.name;
    if (!facesPoint(polygon, pose.position)) {
      if (face.corners[0][2] + face.corners[2][2] == 0.0) continue;  // it stands on that face
      turned_away.push_back(std::move(polygon));
      turned_away_names.push_back(full_name);
      continue;
    }
    polygon.surface = addSurface(full_name);
    polygons.push_back(polygon);
  }
}

void Scene::showAllSides() {
  for (std::size_t i = 0; i < turned_away.size(); ++i) {
    turned_away[i].surface = addSurface(turned_away_names[i]);
    polygons.push_back(turned_away[i]);
  }
  turned_away.clear();
  turned_away_names.clear();
}

void Scene::addClutterBox(const SceneBox& box) {
  for (const BoxFace& face : kFaces) polygons.push_back(facePolygon(box, face));
}

void Scene::addChair(const Vector3d& ground, double yaw) {
  const SceneBox chair{ground, Vector3d(0.40, 0.40, 1.0), yaw};
  const auto at = [&chair](double x, double y, double z) { return boxPoint(chair, x, y, z); };
  addClutterBox({at(0, 0, 0.43), Vector3d(0.42, 0.42, 0.03), yaw});
  for (const double z : {0.58, 0.72, 0.86}) addClutterBox({at(0, 0.95, z), Vector3d(0.38, 0.025, 0.07), yaw});
  for (const double x : {-0.9, 0.9}) {
    cylinders.push_back({at(x, -0.9, 0.0), at(x, -0.9, 0.43), 0.018});
    cylinders.push_back({at(x, 0.95, 0.0), at(x, 0.95, 0.95), 0.018});
  }
}

}  // namespace epcc
