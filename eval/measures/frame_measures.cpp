// SPDX-License-Identifier: BSD-3-Clause
// Builds the overlap table once and hands it to every measure.
#include "eval/measures/frame_measures.h"

#include <cmath>

namespace epcc {

FrameMeasures& FrameMeasures::operator+=(const FrameMeasures& other) {
  paper += other.paper;
  segcomp += other.segcomp;
  instances += other.instances;
  planes += other.planes;
  return *this;
}

OverlapTable overlapTable(const LabelledFrame& frame, const PlaneSegmentation& segmentation) {
  std::vector<std::uint8_t> valid(frame.depth.data.size());
  for (std::size_t i = 0; i < valid.size(); ++i)
    valid[i] = std::isfinite(frame.depth.data[i]) && frame.depth.data[i] > 0.0F ? 1 : 0;
  return OverlapTable(segmentation.labels, {frame.labels.data.begin(), frame.labels.data.end()}, valid);
}

FrameMeasures measureFrame(const LabelledFrame& frame, const PlaneSegmentation& segmentation) {
  const OverlapTable table = overlapTable(frame, segmentation);
  const std::vector<PlaneError> errors = planeErrors(table, truePlanes(frame.camera.extra), segmentation.planes);
  return {paperMeasures(table), segcompMeasures(table), instanceMeasures(table), sumPlaneErrors(errors)};
}

}  // namespace epcc
