// SPDX-License-Identifier: BSD-3-Clause
// What the examples look at: the corner of a room, 320x240, with the white noise of a depth camera.
#pragma once

#include <epcc_segmentation/depth_frame.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace example {

/// 320x240 pixels, about 77 degrees wide.
inline epcc::PinholeCamera camera() {
  epcc::PinholeCamera camera;
  camera.width = 320;
  camera.height = 240;
  camera.fx = camera.fy = 200.0;
  camera.cx = 159.5;
  camera.cy = 119.5;
  return camera;
}

/// Depth in metres, row by row: a floor 1 m below the camera, a wall 3 m ahead, a wall 1.5 m to the right. The noise
/// has a standard deviation of 0.001 z^2 on what faces the camera, and more on what is slanted. The camera may be
/// further forward, metres.
inline std::vector<float> depthOfRoom(unsigned seed = 0, double forward = 0.0) {
  const epcc::PinholeCamera c = camera();
  std::mt19937 random(seed);
  std::vector<float> depth;
  for (int row = 0; row < c.height; ++row) {
    for (int column = 0; column < c.width; ++column) {
      const double down = (row - c.cy) / c.fy;
      const double right = (column - c.cx) / c.fx;
      // The nearest of the three.
      const double inverse_depth = std::max({1.0 / (3.0 - forward), down / 1.0, right / 1.5});
      const double z = 1.0 / inverse_depth;
      const double slope = inverse_depth == down / 1.0 ? z / 1.0 : inverse_depth == right / 1.5 ? z / 1.5 : 0.0;
      double normal = -6.0;  // twelve even numbers add up to nearly normal ones, the same on every machine
      for (int i = 0; i < 12; ++i) normal += static_cast<double>(random()) / 4294967296.0;
      depth.push_back(static_cast<float>(z + 0.001 * z * z * std::hypot(1.0, slope) * normal));
    }
  }
  return depth;
}

}  // namespace example
