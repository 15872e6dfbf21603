// SPDX-License-Identifier: BSD-3-Clause
// What is kept of a frame: its labels, on a grid, and where it was seen from.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <memory>
#include <vector>

#include "epcc_segmentation/known_planes.h"
#include "epcc_segmentation/plane_segmentation.h"

namespace epcc {

struct Keyframe {
  /// Row-major; 0 none, k the plane of track_of_plane[k - 1], one more than these: not looked at. Null before there was
  /// a frame.
  std::shared_ptr<std::vector<std::int32_t>> labels;
  int width = 0, height = 0;
  std::vector<int> track_of_plane;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();  ///< camera to map

  /// Of as many rows and columns as a frame of this size is segmented on. What others hold of the labels stays.
  void take(const PlaneSegmentation& segmentation, const std::vector<int>& tracks, const Eigen::Isometry3d& camera,
            const Continuation& continuation);

 private:
  void leaveOut(int row, int column, int side);
};

/// Pixels of a frame that a label of its keyframe stands for, in each direction.
int keyframeStep(const PlaneSegmentation& segmentation);

}  // namespace epcc
