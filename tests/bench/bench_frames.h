// SPDX-License-Identifier: BSD-3-Clause
// The frames that are timed: rendered scenes with the noise of a stereo camera, and those of a folder.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "datasets/files/labelled_frame.h"
#include "epcc_segmentation/depth_frame.h"
#include "epcc_segmentation/sensor_model.h"

namespace epcc::bench {

/// A frame in memory.
struct BenchFrame {
  LabelledFrame data;
  std::vector<std::uint16_t> units;  ///< the depths in whole units of data.camera.depth_scale; empty for a scan
  SensorModel sensor = *SensorModel::preset("realsense");

  DepthFrame view() const { return frameView(data); }
  /// The same depths in 16 bits.
  DepthFrame viewOfUnits() const;
};

/// Makes or reads a frame; the same each time, and at the second call at once.
using FrameOf = std::function<const BenchFrame&()>;

/// Scene "a" to "d" on a grid, with the error of a stereo camera times `noise`, as the sensor model says too.
FrameOf renderedFrame(int width, int height, const std::string& scene = "b", double noise = 1.0);
/// k x k facets, each inclined by itself.
FrameOf facetFrame(int width, int height, int k);
/// Scene "b" with uneven clutter in so many percent of its blocks of 16 x 16 pixels.
FrameOf clutterFrame(int width, int height, int percent);

/// Names and frames of a folder, in the native format or another that datasets/ knows. Throws InputError.
std::vector<std::pair<std::string, FrameOf>> framesOfFolder(const std::string& folder);

}  // namespace epcc::bench
