// SPDX-License-Identifier: BSD-3-Clause
// The frames that are timed: a rendered scene with the noise of a stereo camera, on grids of several sizes.
#pragma once

#include "datasets/files/labelled_frame.h"
#include "epcc_segmentation/depth_frame.h"
#include "epcc_segmentation/sensor_model.h"

namespace epcc::bench {

/// A frame in memory.
struct BenchFrame {
  LabelledFrame data;
  SensorModel sensor = *SensorModel::preset("realsense");

  DepthFrame view() const { return DepthFrame::fromDepth(data.depth.data.data(), data.camera.camera); }
};

/// The scene on a grid; rendered at the first call, then kept.
const BenchFrame& benchFrame(int width, int height);

}  // namespace epcc::bench
