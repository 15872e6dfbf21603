// SPDX-License-Identifier: BSD-3-Clause
// Views that hold most of the points; far strays do not make everything else small.
#include "eval/view/view_camera.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

#include "datasets/support/quantile.h"

namespace epcc {
namespace {

constexpr double kRadians = M_PI / 180.0;
constexpr double kInPicture = 0.99;  // share of the points
constexpr double kReach = 0.85;      // of a scanner's points: the far ones are few and wide apart
constexpr double kSceneMargin = 1.06;
constexpr double kNarrowest = 1.0, kWidest = 120.0;  // degrees
constexpr double kPickPixels = 4.0;

/// Right, up and forward of a camera, perpendicular.
struct Axes {
  Eigen::Vector3d right, up, forward;
};

Axes axesOf(const Eigen::Vector3d& forward, const Eigen::Vector3d& up) {
  Axes axes;
  axes.forward = forward.normalized();
  axes.right = axes.forward.cross(up).normalized();
  axes.up = axes.right.cross(axes.forward);
  return axes;
}

/// Median of the coordinates: the middle of what is seen.
Eigen::Vector3d middleOf(const ViewScene& scene) {
  Eigen::Vector3d middle;
  for (int k = 0; k < 3; ++k) {
    std::vector<float> values;
    for (const ViewPoint& point : scene.points) values.push_back(point.position(k));
    middle(k) = static_cast<double>(quantile(values, 0.5));
  }
  return middle;
}

double radiusAbout(const ViewScene& scene, const Eigen::Vector3d& middle, double share) {
  std::vector<float> distances;
  for (const ViewPoint& point : scene.points) distances.push_back((point.position - middle.cast<float>()).norm());
  return static_cast<double>(quantile(distances, share));
}

/// The angle of a picture that holds the points in both directions.
double angleFor(const ViewScene& scene, const ViewCamera& camera, double aspect) {
  const Axes axes = axesOf(camera.target - camera.position, camera.up);
  std::vector<double> tangents;
  for (const ViewPoint& point : scene.points) {
    const Eigen::Vector3d ray = point.position.cast<double>() - camera.position;
    const double depth = ray.dot(axes.forward);
    if (depth > 0.0)
      tangents.push_back(std::max(std::abs(ray.dot(axes.up)), std::abs(ray.dot(axes.right)) / aspect) / depth);
  }
  if (tangents.empty()) return camera.angle;
  return std::clamp(2.0 * std::atan(kSceneMargin * quantile(tangents, kInPicture)) / kRadians, kNarrowest, kWidest);
}

/// From behind the sensor rather than in it, so that near points are not cut off by the window's edges.
ViewCamera fromSensor(const ViewScene& scene, const Eigen::Vector3d& middle, double aspect) {
  ViewCamera camera;
  const ViewSensor& sensor = scene.sensor;
  const double ahead = std::max(1e-3, (middle - sensor.origin).dot(sensor.forward));
  camera.position = sensor.origin - 0.1 * ahead * sensor.forward;
  camera.target = sensor.origin + ahead * sensor.forward;
  camera.up = sensor.up;
  camera.angle = angleFor(scene, camera, aspect);
  return camera;
}

ViewCamera fromOutside(const ViewScene& scene, const Eigen::Vector3d& middle, double radius, double elevation) {
  const ViewSensor& sensor = scene.sensor;
  const Eigen::Vector3d right = sensor.forward.cross(sensor.up);
  const Eigen::Vector3d level = (sensor.forward + 0.35 * right).normalized();
  ViewCamera camera;
  const double away = radius / std::sin(0.5 * camera.angle * kRadians);
  camera.position =
      middle - away * (std::cos(elevation * kRadians) * level - std::sin(elevation * kRadians) * sensor.up);
  camera.target = middle;
  camera.up = elevation > 80.0 ? sensor.forward : sensor.up;
  return camera;
}

}  // namespace

ViewPlace firstPlace(const ViewScene& scene) {
  return scene.sensor.is_scanner ? ViewPlace::Slanted : ViewPlace::Sensor;
}

ViewCamera viewFrom(ViewPlace place, const ViewScene& scene, double aspect) {
  const ViewSensor& sensor = scene.sensor;
  if (scene.points.empty()) return {sensor.origin, sensor.origin + sensor.forward, sensor.up, 60.0};
  const Eigen::Vector3d middle = sensor.is_scanner ? sensor.origin : middleOf(scene);
  if (place == ViewPlace::Sensor) return fromSensor(scene, middleOf(scene), aspect);
  const double radius = std::max(1e-3, radiusAbout(scene, middle, sensor.is_scanner ? kReach : kInPicture));
  ViewCamera camera = fromOutside(scene, middle, radius, place == ViewPlace::Top ? 90.0 : 35.0);
  if (!sensor.is_scanner) camera.angle = angleFor(scene, camera, aspect);
  return camera;
}

bool projectPoint(const ViewCamera& camera, int width, int height, const Eigen::Vector3d& point, Eigen::Vector2d& pixel,
                  double& distance) {
  const Axes axes = axesOf(camera.target - camera.position, camera.up);
  const Eigen::Vector3d ray = point - camera.position;
  distance = ray.dot(axes.forward);
  if (!(distance > 0.0)) return false;
  const double focal = 0.5 * height / std::tan(0.5 * camera.angle * kRadians);
  pixel.x() = 0.5 * (width - 1) + focal * ray.dot(axes.right) / distance;
  pixel.y() = 0.5 * (height - 1) - focal * ray.dot(axes.up) / distance;
  return true;
}

int pointAt(const ViewScene& scene, const ViewCamera& camera, int width, int height, double x, double y) {
  int nearest = -1;
  double nearest_distance = 0.0;
  for (std::size_t i = 0; i < scene.points.size(); ++i) {
    Eigen::Vector2d pixel;
    double distance = 0.0;
    if (!projectPoint(camera, width, height, scene.points[i].position.cast<double>(), pixel, distance)) continue;
    if ((pixel - Eigen::Vector2d(x, y)).norm() > kPickPixels) continue;
    if (nearest >= 0 && distance >= nearest_distance) continue;
    nearest = static_cast<int>(i);
    nearest_distance = distance;
  }
  return nearest;
}

}  // namespace epcc
