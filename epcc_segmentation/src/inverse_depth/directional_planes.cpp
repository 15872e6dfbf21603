// SPDX-License-Identifier: BSD-3-Clause
// Walks over the scan lines, once for S1 and once for S2.
#include "inverse_depth/directional_planes.h"

namespace epcc {

DirectionalPlanes::DirectionalPlanes(bool columns, const InverseDepthParameters& parameters, const SensorModel& sensor)
    : columns_(columns), parameters_(parameters.expert.planes), lines_(columns), plane_growing_(parameters, sensor) {}

void DirectionalPlanes::configure(const InverseDepthParameters& parameters, const SensorModel& sensor) {
  parameters_ = parameters.expert.planes;
  plane_growing_.configure(parameters, sensor);
}

void DirectionalPlanes::setActive(bool active) {
  active_ = active;
  if (!active) plane_points_.clear();
}

void DirectionalPlanes::beginLines(const InverseDepthImage& image, const InverseDepthParameters& parameters) {
  if (active_) lines_.begin(image, parameters);
}

void DirectionalPlanes::growPlanes(const InverseDepthImage& image) {
  if (!active_) return;
  plane_growing_.begin(pixelPitch(columns_ ? image.along : image.across), !image.planar_rows);
  for (int i = 0; i < lines_.scanLines(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    const ScanLineRays rays =
        columns_ ? ScanLineRays{image.across[k], image.forward[k]} : ScanLineRays{image.along[k], 1.0};
    plane_growing_.addLine(rays, lines_.lines(i), lines_.lineCount(i));
  }
  plane_points_.clear();
  for (const GrownPlane& plane : plane_growing_.planes()) {
    const bool large_enough = plane.moments.n >= parameters_.min_points && plane.segments >= parameters_.min_segments;
    plane_points_.push_back(large_enough ? plane.moments.n : 0.0);
  }
}

}  // namespace epcc
