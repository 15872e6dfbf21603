// SPDX-License-Identifier: BSD-3-Clause
// Every primitive is drawn into the part of the image that it can reach, nearest depth first.
#include "datasets/rendered/scene_renderer.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace epcc {
namespace {

using Eigen::Vector3d;
using Eigen::Vector4d;

constexpr double kNear = 0.02;  // metres: what reaches closer is looked for in the whole image

Vector3d rayOf(const PinholeCamera& camera, int row, int column) {
  return {(column - camera.cx) / camera.fx, (row - camera.cy) / camera.fy, 1.0};
}

// Plane through a polygon in the camera frame, the camera on its positive side.
Vector4d planeOf(const std::vector<Vector3d>& v) {
  const Vector3d normal = (v[1] - v[0]).cross(v[2] - v[0]).normalized();
  const Vector4d plane(normal.x(), normal.y(), normal.z(), -normal.dot(v[0]));
  return plane(3) < 0.0 ? Vector4d(-plane) : plane;
}

// Part of the image that can show what lies within the hull of some points, in pixels.
struct PixelBox {
  int first_row, last_row, first_column, last_column;
};

PixelBox reachOf(const std::vector<Vector3d>& points, const PinholeCamera& camera) {
  const PixelBox whole{0, camera.height - 1, 0, camera.width - 1};
  double left = 1e9, right = -1e9, top = 1e9, bottom = -1e9;
  for (const Vector3d& p : points) {
    if (p.z() < kNear) return whole;
    const double column = camera.cx + camera.fx * p.x() / p.z(), row = camera.cy + camera.fy * p.y() / p.z();
    left = std::min(left, column);
    right = std::max(right, column);
    top = std::min(top, row);
    bottom = std::max(bottom, row);
  }
  const auto clamped = [](double value, int last) { return static_cast<int>(std::clamp(value, -1.0, last + 1.0)); };
  return {std::max(0, clamped(std::floor(top), whole.last_row)),
          std::min(whole.last_row, clamped(std::ceil(bottom), whole.last_row)),
          std::max(0, clamped(std::floor(left), whole.last_column)),
          std::min(whole.last_column, clamped(std::ceil(right), whole.last_column))};
}

std::vector<Vector3d> cornersAround(const Vector3d& a, const Vector3d& b, double radius) {
  const Vector3d low = a.cwiseMin(b).array() - radius, high = a.cwiseMax(b).array() + radius;
  std::vector<Vector3d> corners;
  for (int i = 0; i < 8; ++i)
    corners.emplace_back((i & 1) ? low.x() : high.x(), (i & 2) ? low.y() : high.y(), (i & 4) ? low.z() : high.z());
  return corners;
}

// Calls depth_at(ray), metres or <= 0 for a miss, in the box and keeps the nearest.
template <typename DepthAt>
void draw(SceneView& view, const PinholeCamera& camera, const PixelBox& box, int surface, const DepthAt& depth_at) {
  for (int row = box.first_row; row <= box.last_row; ++row) {
    for (int column = box.first_column; column <= box.last_column; ++column) {
      const double z = depth_at(rayOf(camera, row, column));
      float& nearest = view.depth.at(row, column);
      if (!(z > 0.0) || (nearest > 0.0F && z >= static_cast<double>(nearest))) continue;
      nearest = static_cast<float>(z);
      view.surface.at(row, column) = surface;
    }
  }
}

void drawPolygon(SceneView& view, const PinholeCamera& camera, const std::vector<Vector3d>& vertices, int surface) {
  const Vector4d plane = planeOf(vertices);
  const Vector3d normal = plane.head<3>();
  std::vector<Vector3d> sides;  // planes through the camera and an edge
  for (std::size_t i = 0; i < vertices.size(); ++i)
    sides.push_back(vertices[i].cross(vertices[(i + 1) % vertices.size()]));
  draw(view, camera, reachOf(vertices, camera), surface, [&](const Vector3d& ray) {
    const double z = -plane(3) / normal.dot(ray);  // Eq. 10
    if (!(z > 0.0)) return 0.0;
    bool positive = false, negative = false;
    for (const Vector3d& side : sides) {
      const double distance = side.dot(ray);
      positive = positive || distance > 0.0;
      negative = negative || distance < 0.0;
    }
    return positive && negative ? 0.0 : z;
  });
}

void drawSphere(SceneView& view, const PinholeCamera& camera, const Vector3d& center, double radius) {
  const double offset = center.squaredNorm() - radius * radius;
  draw(view, camera, reachOf(cornersAround(center, center, radius), camera), kClutter, [&](const Vector3d& ray) {
    const double a = ray.squaredNorm(), b = ray.dot(center), disc = b * b - a * offset;
    return disc < 0.0 ? 0.0 : (b - std::sqrt(disc)) / a;
  });
}

// Nearest hit of a ray from the origin with a closed cylinder, 0 if none.
double cylinderDepth(const Vector3d& ray, const Vector3d& base, const Vector3d& axis, double length, double radius) {
  double best = std::numeric_limits<double>::infinity();
  const double along = ray.dot(axis), start = base.dot(axis);
  const Vector3d across = ray - along * axis, center = base - start * axis;
  const double a = across.squaredNorm(), b = across.dot(center);
  const double disc = b * b - a * (center.squaredNorm() - radius * radius);
  if (a > 0.0 && disc >= 0.0) {
    const double z = (b - std::sqrt(disc)) / a, height = z * along - start;
    if (z > 0.0 && height >= 0.0 && height <= length) best = z;
  }
  for (const double end : {start, start + length}) {
    const double z = end / along;
    if (z > 0.0 && z < best && (z * across - center).squaredNorm() <= radius * radius) best = z;
  }
  return std::isfinite(best) ? best : 0.0;
}

void drawCylinder(SceneView& view, const PinholeCamera& camera, const Vector3d& base, const Vector3d& top,
                  double radius) {
  const double length = (top - base).norm();
  const Vector3d axis = (top - base) / length;
  draw(view, camera, reachOf(cornersAround(base, top, radius), camera), kClutter,
       [&](const Vector3d& ray) { return cylinderDepth(ray, base, axis, length, radius); });
}

SceneView viewFrom(const Scene& scene, const PinholeCamera& camera, const Eigen::Matrix3d& rotation,
                   const Vector3d& position) {
  SceneView view{DepthImage(camera.width, camera.height), Image<int>(camera.width, camera.height, kClutter),
                 std::vector<Vector4d>(scene.surfaces.size(), Vector4d::Zero())};
  const auto toCamera = [&](const Vector3d& world) -> Vector3d { return rotation * (world - position); };
  for (const ScenePolygon& polygon : scene.polygons) {
    std::vector<Vector3d> vertices;
    for (const Vector3d& vertex : polygon.vertices) vertices.push_back(toCamera(vertex));
    drawPolygon(view, camera, vertices, polygon.surface);
    if (polygon.surface != kClutter) view.planes[static_cast<std::size_t>(polygon.surface)] = planeOf(vertices);
  }
  for (const SceneSphere& s : scene.spheres) drawSphere(view, camera, toCamera(s.center), s.radius);
  for (const SceneCylinder& c : scene.cylinders)
    drawCylinder(view, camera, toCamera(c.base), toCamera(c.top), c.radius);
  return view;
}

}  // namespace

SceneView renderView(const Scene& scene, const PinholeCamera& camera) {
  return viewFrom(scene, camera, scene.pose.rotation(), scene.pose.position);
}

SceneView renderView(const Scene& scene, const PinholeCamera& camera, const Eigen::Isometry3d& camera_to_world) {
  return viewFrom(scene, camera, camera_to_world.linear().transpose(), camera_to_world.translation());
}

DepthImage renderPlane(const Vector4d& plane, const PinholeCamera& camera) {
  DepthImage depth(camera.width, camera.height);
  for (int row = 0; row < camera.height; ++row) {
    for (int column = 0; column < camera.width; ++column) {
      const double z = -plane(3) / plane.head<3>().dot(rayOf(camera, row, column));
      if (std::isfinite(z) && z > 0.0) depth.at(row, column) = static_cast<float>(z);
    }
  }
  return depth;
}

}  // namespace epcc
