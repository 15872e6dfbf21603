// SPDX-License-Identifier: BSD-3-Clause
// Tiny renderer for tests: the inside of a convex room of unbounded planes, with exact labels.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <random>
#include <vector>

#include "epcc_segmentation/depth_frame.h"
#include "epcc_segmentation/sensor_model.h"

namespace epcc::test {

struct RenderedRoom {
  PinholeCamera camera;
  std::vector<float> depth;          // metres
  std::vector<std::int32_t> labels;  // index of the plane seen + 1

  DepthFrame frame() const { return DepthFrame::fromDepth(depth.data(), camera); }
};

inline PinholeCamera testCamera(int width = 160, int height = 120) {
  return {width, height, 0.6 * width, 0.6 * width, 0.5 * (width - 1), 0.5 * (height - 1)};
}

/// Planes (a, b, c, d) with the camera on the positive side; a pixel sees the nearest one (Eq. 10).
inline RenderedRoom renderRoom(const std::vector<Eigen::Vector4d>& planes, const PinholeCamera& camera) {
  RenderedRoom room{camera, {}, {}};
  for (int row = 0; row < camera.height; ++row)
    for (int column = 0; column < camera.width; ++column) {
      const Eigen::Vector3d ray((column - camera.cx) / camera.fx, (row - camera.cy) / camera.fy, 1.0);
      double nearest = std::numeric_limits<double>::infinity();
      std::int32_t label = 0;
      for (std::size_t i = 0; i < planes.size(); ++i) {
        const double z = -planes[i](3) / planes[i].head<3>().dot(ray);
        if (z > 0.0 && z < nearest) {
          nearest = z;
          label = static_cast<std::int32_t>(i + 1);
        }
      }
      room.depth.push_back(label > 0 ? static_cast<float>(nearest) : 0.0f);
      room.labels.push_back(label);
    }
  return room;
}

/// Floor, back wall and a side wall of a room seen from its middle, slightly turned.
inline std::vector<Eigen::Vector4d> cornerPlanes() {
  const auto plane = [](double x, double y, double z, double d) {
    const double norm = std::sqrt(x * x + y * y + z * z);
    return Eigen::Vector4d(x / norm, y / norm, z / norm, d);
  };
  return {plane(0.05, -1.0, -0.1, 1.0), plane(0.1, 0.05, -1.0, 2.5), plane(-1.0, 0.02, -0.15, 0.9)};
}

/// Something square, 0.6 m away, in front of all else.
inline void addBoard(RenderedRoom& room, int row, int column, int size) {
  for (int i = row; i < row + size; ++i)
    for (int j = column; j < column + size; ++j) room.depth[static_cast<std::size_t>(i * room.camera.width + j)] = 0.6f;
}

/// Adds white axial Gaussian noise of the sensor model.
inline void addNoise(RenderedRoom& room, const SensorModel& sensor, unsigned seed) {
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal;
  for (float& z : room.depth)
    if (z > 0.0f) z = static_cast<float>(z + sensor.sigmaZ(z) * normal(generator));
}

}  // namespace epcc::test
