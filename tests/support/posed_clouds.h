// SPDX-License-Identifier: BSD-3-Clause
// Clouds of rendered rooms in any frame, unit and order of pixels.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

#include "tests/support/rendered_room.h"

namespace epcc::test {

/// An organized cloud and the plane that each pixel shows, from 1, 0 none.
struct PosedCloud {
  int width = 0;
  int height = 0;
  std::vector<float> xyz;
  std::vector<std::int32_t> truth;

  std::size_t size() const { return truth.size(); }
};

/// p -> unit * (axes p + origin), NaN stays.
inline PosedCloud moved(PosedCloud cloud, const Eigen::Matrix3d& axes, const Eigen::Vector3d& origin,
                        double unit = 1.0) {
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3d p = Eigen::Map<const Eigen::Vector3f>(&cloud.xyz[3 * i]).cast<double>();
    const Eigen::Vector3d q = unit * (axes * p + origin);
    for (int k = 0; k < 3; ++k) cloud.xyz[3 * i + static_cast<std::size_t>(k)] = static_cast<float>(q(k));
  }
  return cloud;
}

/// The pixel at (row, column) goes to the place that `place` says, in a cloud of width x height.
inline PosedCloud reordered(const PosedCloud& cloud, int width, int height,
                            const std::function<std::size_t(int, int)>& place) {
  PosedCloud other{width, height, std::vector<float>(3 * static_cast<std::size_t>(width * height), NAN),
                   std::vector<std::int32_t>(static_cast<std::size_t>(width * height), 0)};
  for (int row = 0; row < cloud.height; ++row)
    for (int column = 0; column < cloud.width; ++column) {
      const auto from = static_cast<std::size_t>(row * cloud.width + column);
      const std::size_t to = place(row, column);
      for (std::size_t k = 0; k < 3; ++k) other.xyz[3 * to + k] = cloud.xyz[3 * from + k];
      other.truth[to] = cloud.truth[from];
    }
  return other;
}

inline PosedCloud rowsAndColumnsExchanged(const PosedCloud& cloud) {
  return reordered(cloud, cloud.height, cloud.width,
                   [&](int row, int column) { return static_cast<std::size_t>(column * cloud.height + row); });
}

/// A camera's cloud of a room with the noise of a sensor: x right, y down, z forward.
inline PosedCloud cameraCloud(RenderedRoom room) {
  addNoise(room, *SensorModel::parse("0.002,0.001,1"), 7);
  PosedCloud cloud{room.camera.width, room.camera.height, {}, room.labels};
  const DepthFrame frame = room.frame();
  Eigen::Vector3d p;
  for (int row = 0; row < cloud.height; ++row)
    for (int column = 0; column < cloud.width; ++column) {
      const bool is_point = frame.point(row, column, p);
      for (int k = 0; k < 3; ++k) cloud.xyz.push_back(is_point ? static_cast<float>(p(k)) : NAN);
    }
  return cloud;
}

/// A room of four walls at 1.6 m (behind the seam, +y), 1.9, 3 and 4 m from a scanner, whose rings reach neither floor
/// nor ceiling; columns go once round from azimuth `first`, clockwise. 8 mm of noise along the ray.
inline PosedCloud scannerCloud(int width, int height, double first = 0.0, double turn = 2.0 * M_PI) {
  const Eigen::Vector3d normals[4] = {{0, 1, 0}, {1, 0, 0}, {0, -1, 0}, {-1, 0, 0}};
  const double distances[4] = {1.6, 1.9, 3.0, 4.0};
  std::mt19937 generator(11);
  std::normal_distribution<double> noise(0.0, 0.008);
  PosedCloud cloud{width, height, {}, {}};
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column) {
      const double azimuth = first - turn * column / width;
      const double elevation = 0.3 - 0.6 * row / (height - 1);
      const Eigen::Vector3d ray(std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
                                std::sin(elevation));
      double range = std::numeric_limits<double>::infinity();
      std::int32_t label = 0;
      for (int k = 0; k < 4; ++k) {
        const double at = distances[k] / normals[k].dot(ray);
        if (at <= 0.0 || at >= range) continue;
        range = at;
        label = k + 1;
      }
      range += noise(generator);
      for (int k = 0; k < 3; ++k) cloud.xyz.push_back(static_cast<float>(range * ray(k)));
      cloud.truth.push_back(label);
    }
  return cloud;
}

}  // namespace epcc::test
