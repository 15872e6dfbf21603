// SPDX-License-Identifier: BSD-3-Clause
// Built-in paths are smooth functions of the time, in the frame of the scene's own camera.
#include "datasets/rendered/camera_path.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "datasets/rendered/scene_renderer.h"
#include "datasets/support/degree.h"
#include "datasets/support/quantile.h"

namespace epcc {
namespace {

using Eigen::AngleAxisd;
using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr double kPeriod = 10.0;         // s
constexpr double kSwayOfDepth = 0.06;    // of the distance to what is looked at
constexpr double kMostSwayDepth = 3.0;   // m: a long corridor is not wider for it
constexpr double kMostOrbitDepth = 1.5;  // m
constexpr double kWalkOfDepth = 0.35;
constexpr double kOrbitAngle = 25.0 * kDegree;

/// What the camera looks at: the median depth in the middle of its view, metres.
double depthAhead(const Scene& scene) {
  const PinholeCamera camera{40, 30, 100.0, 100.0, 19.5, 14.5};
  std::vector<double> depths;
  for (const float z : renderView(scene, camera).depth.data)
    if (z > 0.0F) depths.push_back(static_cast<double>(z));
  return depths.empty() ? 1.0 : median(std::move(depths));
}

Isometry3d turned(double yaw, double pitch, double roll) {
  return Isometry3d(AngleAxisd(yaw, Vector3d::UnitY()) * AngleAxisd(pitch, Vector3d::UnitX()) *
                    AngleAxisd(roll, Vector3d::UnitZ()));
}

/// All functions are 0 at the phase 0: the way begins where the scene's camera stands.
Isometry3d swayAt(double phase, double ahead) {
  const double size = kSwayOfDepth * std::min(ahead, kMostSwayDepth);
  const Vector3d at(1.6 * size * std::sin(phase), size * std::sin(2.0 * phase), 0.8 * size * std::sin(3.0 * phase));
  return Eigen::Translation3d(at) * turned(6.0 * kDegree * std::sin(2.0 * phase), 3.0 * kDegree * std::sin(3.0 * phase),
                                           2.0 * kDegree * std::sin(phase));
}

/// About the upright through what is looked at; the camera's own vertical is taken for it.
Isometry3d orbitAt(double phase, double ahead) {
  const Isometry3d round(AngleAxisd(kOrbitAngle * std::sin(phase), Vector3d::UnitY()));
  const double radius = std::min(ahead, kMostOrbitDepth);
  const Eigen::Translation3d there(0.0, 0.0, radius), back(0.0, 0.0, -radius);
  return there * round * back;
}

Isometry3d walkAt(double phase, double ahead) {
  const double way = 0.5 * kWalkOfDepth * ahead * (1.0 - std::cos(phase));
  const double step = std::sin(8.0 * phase);
  const Vector3d at(0.02 * std::sin(4.0 * phase), 0.01 * step, way);
  return Eigen::Translation3d(at) *
         turned(8.0 * kDegree * std::sin(2.0 * phase), 0.5 * kDegree * step, 1.0 * kDegree * std::sin(4.0 * phase));
}

struct Path {
  const char* name;
  Isometry3d (*at)(double phase, double ahead);
};
constexpr Path kPaths[] = {{"sway", swayAt}, {"orbit", orbitAt}, {"walk", walkAt}};

}  // namespace

std::vector<std::string> pathNames() {
  std::vector<std::string> names;
  for (const Path& path : kPaths) names.emplace_back(path.name);
  return names;
}

Isometry3d cameraToWorld(const CameraPose& pose) {
  Isometry3d camera = Isometry3d::Identity();
  camera.linear() = pose.rotation().transpose();
  camera.translation() = pose.position;
  return camera;
}

Trajectory builtInPath(const std::string& name, const Scene& scene, std::size_t frames, double rate) {
  const auto path = std::find_if(std::begin(kPaths), std::end(kPaths), [&](const Path& p) { return name == p.name; });
  if (path == std::end(kPaths)) throw std::invalid_argument("unknown path '" + name + "'");
  const Isometry3d start = cameraToWorld(scene.pose);
  const double ahead = depthAhead(scene);
  Trajectory trajectory;
  for (std::size_t i = 0; i < frames; ++i) {
    const double time = static_cast<double>(i) / rate;
    trajectory.push_back({time, start * path->at(2.0 * M_PI * time / kPeriod, ahead)});
  }
  return trajectory;
}

Trajectory pathAlong(const Trajectory& recorded, const Scene& scene, std::size_t frames, double rate) {
  const double first = recorded.front().time, duration = recorded.back().time - first;
  const Isometry3d moved = cameraToWorld(scene.pose) * recorded.front().pose.inverse();
  const double all = std::floor(duration * rate + 1e-6) + 1.0;
  const double count = frames == 0 ? all : std::min(static_cast<double>(frames), all);
  Trajectory trajectory;
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    const double time = static_cast<double>(i) / rate;
    trajectory.push_back({time, moved * poseBetween(recorded, first + time)});
  }
  return trajectory;
}

}  // namespace epcc
