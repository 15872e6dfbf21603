// SPDX-License-Identifier: BSD-3-Clause
// The depth image that the programs look at: a wall 2 m ahead and a floor 0.6 m below.
#pragma once

#include <epcc_segmentation/depth_frame.h>

#include <vector>

struct WallAndFloor {
  epcc::PinholeCamera camera;
  std::vector<float> depth;

  WallAndFloor() {
    camera.width = 160;
    camera.height = 120;
    camera.fx = camera.fy = 130.0;
    camera.cx = 79.5;
    camera.cy = 59.5;
    for (int row = 0; row < camera.height; ++row) {
      const double down = (row - camera.cy) / camera.fy;
      const double z = down > 0.3 ? 0.6 / down : 2.0;
      depth.insert(depth.end(), static_cast<std::size_t>(camera.width), static_cast<float>(z));
    }
  }
  epcc::DepthFrame frame() const { return epcc::DepthFrame::fromDepth(depth.data(), camera); }
};
