// SPDX-License-Identifier: BSD-3-Clause
// Rooms with errors of known size and length, whose sensor is measured.
#pragma once

#include <cmath>
#include <random>
#include <vector>

#include "epcc_segmentation/sensor_estimation.h"
#include "tests/support/rendered_room.h"

namespace epcc::test {

inline RenderedRoom room(int width = 640, int height = 480) {
  return renderRoom(cornerPlanes(), testCamera(width, height));
}

/// Error of standard deviation sigma(z), smooth over `radius` pixels.
inline void addBlotches(RenderedRoom& frame, const SensorModel& sensor, double radius, unsigned seed) {
  const int width = frame.camera.width, height = frame.camera.height;
  std::mt19937 generator(seed);
  std::normal_distribution<float> normal;
  std::vector<float> field(frame.depth.size());
  for (auto& value : field) value = normal(generator);
  // A white field filtered with a Gaussian of standard deviation radius / sqrt(2) has the correlation length radius.
  const int reach = static_cast<int>(std::ceil(2.5 * radius));
  std::vector<float> kernel;
  double squares = 0.0;
  for (int k = -reach; k <= reach; ++k) {
    kernel.push_back(static_cast<float>(std::exp(-k * k / (radius * radius))));
    squares += static_cast<double>(kernel.back() * kernel.back());
  }
  const auto filter = [&](int count, int lines, int step, int line_step) {
    std::vector<float> line(static_cast<std::size_t>(count));
    for (int i = 0; i < lines; ++i) {
      for (int x = 0; x < count; ++x) {
        float sum = 0.0f;
        for (int k = -reach; k <= reach; ++k)
          sum += kernel[static_cast<std::size_t>(k + reach)] *
                 field[static_cast<std::size_t>(i * line_step + (x + k + count) % count * step)];
        line[static_cast<std::size_t>(x)] = sum;
      }
      for (int x = 0; x < count; ++x) field[static_cast<std::size_t>(i * line_step + x * step)] = line[x];
    }
  };
  filter(width, height, 1, width);
  filter(height, width, width, 1);
  for (std::size_t i = 0; i < frame.depth.size(); ++i)
    if (frame.depth[i] > 0.0f)
      frame.depth[i] += static_cast<float>(sensor.sigmaZ(static_cast<double>(frame.depth[i])) *
                                           static_cast<double>(field[i]) / squares);
}

inline RenderedRoom headOnWall() {
  return renderRoom({cornerPlanes()[1]}, testCamera(640, 480));
}

inline double ratioAt(double z, const SensorEstimate& estimate, const SensorModel& truth) {
  return estimate.model().sigmaZ(z) / truth.sigmaZ(z);
}

/// The whole frame in another unit of length.
inline RenderedRoom scaled(RenderedRoom frame, float factor) {
  for (float& z : frame.depth) z *= factor;
  return frame;
}

}  // namespace epcc::test
