// SPDX-License-Identifier: BSD-3-Clause
// A cloud in the frame of its sensor, and results back in the caller's.
#pragma once

#include <cstdint>
#include <vector>

#include "epcc_segmentation/cloud_geometry.h"
#include "epcc_segmentation/depth_frame.h"
#include "epcc_segmentation/plane_segmentation.h"

namespace epcc {

/// Clouds whose frame, unit or order of pixels is another than that of the algorithm, copied into those. Keeps its
/// memory.
class SensorCloud {
 public:
  /// `frame` has a geometry(). The view is this object's until the next call.
  DepthFrame of(const DepthFrame& frame, int threads);
  /// The labels of the caller's pixels in the order of of()'s.
  void takeLabels(const std::vector<std::int32_t>& labels, std::vector<std::int32_t>& own) const;
  /// What was found in of()'s frame, in the caller's frame and order of pixels.
  void giveBack(PlaneSegmentation& result);

 private:
  std::size_t callersPixel(int row, int column) const;  // or kNoPixel, where the rings' shifts leave none
  void copyRow(const DepthFrame& frame, int row, float* to) const;
  void giveBackLabels(PlaneSegmentation& result);
  void giveBackSegments(PlaneSegmentation& result) const;

  CloudGeometry geometry_;
  bool is_transposed_ = false;  // the caller's view
  int width_ = 0, height_ = 0;  // of the caller's cloud, as it lies in memory
  int columns_ = 0, rows_ = 0;  // in the order of the sensor
  std::vector<float> points_;   // four floats each
  std::vector<std::int32_t> labels_;
};

/// The frame itself, or what `memory` makes of it if it has a geometry().
inline DepthFrame inSensorFrame(const DepthFrame& frame, SensorCloud& memory, int threads = 1) {
  return frame.geometry() == nullptr ? frame : memory.of(frame, threads);
}

/// A plane of a sensor's frame in the frame that the sensor's pose is in.
Plane inCloudFrame(const Plane& plane, const SensorPose& pose);

}  // namespace epcc
