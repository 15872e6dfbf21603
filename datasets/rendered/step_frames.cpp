// SPDX-License-Identifier: BSD-3-Clause
// A step is two parallel planes side by side, some distance apart in depth.
#include "datasets/rendered/step_frames.h"

#include <algorithm>
#include <cmath>

#include "datasets/rendered/scene.h"

namespace epcc {

namespace {

/// A fraction in [0, 1) that is spread evenly over the seeds.
double spread(std::uint64_t seed, double ratio) {
  const double value = static_cast<double>(seed + 1) * ratio;
  return value - std::floor(value);
}

LabelledFrame renderStep(const StepScene& scene, const PinholeCamera& camera, std::uint64_t seed) {
  const double yaw = (40.0 * spread(seed, 0.618034) - 20.0) * M_PI / 180.0;
  const double shift = 0.4 * spread(seed, 0.414214) - 0.2;
  LabelledFrame frame;
  frame.name = scene.name;
  frame.camera.camera = camera;
  frame.depth = DepthImage(camera.width, camera.height);
  frame.labels = LabelImage(camera.width, camera.height, 1);
  const double wall = scene.distance * std::cos(yaw);
  for (int row = 0; row < camera.height; ++row)
    for (int column = 0; column < camera.width; ++column) {
      const double x = (column - camera.cx) / camera.fx, y = (row - camera.cy) / camera.fy;
      const double facing = std::sin(yaw) * x + std::cos(yaw);
      // The outline lies in the plane that is nearer: doors are cut into the wall, frames stand before it.
      const double z = (wall + std::min(scene.step, 0.0)) / facing;
      const double u = std::abs(z * (std::cos(yaw) * x - std::sin(yaw)) + scene.distance * std::sin(yaw) - shift);
      const double v = z * y;
      const auto within = [&](double rim) {
        return u < 0.5 * scene.width - rim && v > scene.top + rim && v < scene.bottom - rim;
      };
      const bool inner = scene.rim > 0.0 && within(scene.rim);
      const bool second = within(0.0) && !inner;
      frame.depth.at(row, column) = static_cast<float>((wall + (second ? scene.step : 0.0)) / facing);
      if (second) frame.labels.at(row, column) = 2;
      if (inner) frame.labels.at(row, column) = kIgnoreLabel;
    }
  return frame;
}

}  // namespace

StepScene doorScene(double step) {
  return {"door", 3.0, step, 0.90, -0.80, 8.0, 0.0};
}

StepScene pictureFrameScene(double step) {
  return {"frame", 1.0, -step, 0.60, -0.25, 0.25, 0.08};
}

StepSensor kinectSensor() {
  StepSensor sensor{"kinect-v1", {640, 480, 525.0, 525.0, 319.5, 239.5}, parseNoise("stereo").value()};
  sensor.noise.preset = sensor.name;
  sensor.noise.stereo.sigma_w = 0.0014;
  sensor.noise.stereo.sigma_floor = 0.0009;
  sensor.noise.stereo.blotch = 4.0;
  sensor.noise.stereo.outlier_share = 0.0;
  return sensor;
}

StepSensor realsenseSensor() {
  return {"realsense", sceneCamera(), parseNoise("stereo").value()};
}

RenderedFrames::Make stepWithNoise(const StepScene& scene, const StepSensor& sensor) {
  return [scene, sensor](std::uint64_t seed) {
    LabelledFrame frame = renderStep(scene, sensor.camera, seed);
    applyNoise(frame, sensor.noise, seed);
    return frame;
  };
}

}  // namespace epcc
