// SPDX-License-Identifier: BSD-3-Clause
// Clouds get another geometry, depth images other depths.
#include "datasets/sources/reading_options.h"

#include <cmath>

#include "datasets/files/cloud_frame.h"

namespace epcc {

namespace {

void readCloudAs(LabelledFrame& frame, const ReadingOptions& options) {
  CloudOptions all = frame.known;
  all.sensor = options.sensor;
  all.unit = options.unit.value_or(0.0);
  all.min_depth = options.min_depth;
  all.max_depth = options.max_depth;
  if (options.invalid) all.invalid = static_cast<float>(*options.invalid);
  findCloudGeometry(frame, all);
}

void readDepthAs(LabelledFrame& frame, const ReadingOptions& options) {
  const double scale = frame.camera.depth_scale;
  if (options.invalid)
    for (float& z : frame.depth.data)
      if (z == static_cast<float>(*options.invalid * scale)) z = 0.0F;
  if (options.unit) {
    for (float& z : frame.depth.data) z = static_cast<float>(static_cast<double>(z) * (*options.unit / scale));
    frame.camera.depth_scale = *options.unit;
  }
  DepthOptions rest;
  rest.is_distance = options.is_distance;
  rest.min_depth = options.min_depth;
  rest.max_depth = options.max_depth;
  const DepthFrame view = DepthFrame::fromDepth(frame.depth.data.data(), frame.camera.camera).readAs(rest);
  for (int row = 0; row < view.height(); ++row) {
    float* depths = frame.depth.data.data() + view.index(row, 0);
    view.depthRow(row, depths);
  }
}

}  // namespace

bool ReadingOptions::areDefault() const {
  return sensor == CloudOptions::Sensor::Any && !unit && !invalid && min_depth <= 0.0 && std::isinf(max_depth) &&
         !is_distance;
}

void readAs(LabelledFrame& frame, const ReadingOptions& options) {
  if (options.areDefault()) return;
  if (frame.scan.empty())
    readDepthAs(frame, options);
  else
    readCloudAs(frame, options);
}

}  // namespace epcc
