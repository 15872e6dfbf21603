// SPDX-License-Identifier: BSD-3-Clause
// Walks over the scan lines, once for S1 and once for S2.
#include "inverse_depth/directional_planes.h"

namespace epcc {

DirectionalPlanes::DirectionalPlanes(bool columns, const InverseDepthParameters& parameters, const SensorModel& sensor)
    : columns_(columns),
      parameters_(parameters.expert.planes),
      line_growing_(parameters),
      plane_growing_(parameters, sensor) {}

void DirectionalPlanes::configure(const InverseDepthParameters& parameters, const SensorModel& sensor) {
  parameters_ = parameters.expert.planes;
  line_growing_.configure(parameters);
  plane_growing_.configure(parameters, sensor);
}

void DirectionalPlanes::setActive(bool active) {
  active_ = active;
  if (!active) plane_points_.clear();
}

void DirectionalPlanes::growLines(const InverseDepthImage& image) {
  if (!active_) return;
  const int scan_lines = columns_ ? image.width : image.height;
  const int length = columns_ ? image.height : image.width;
  const float* w = columns_ ? image.w_transposed.data() : image.w.data();
  const float* weight = columns_ ? image.weight_transposed.data() : image.weight.data();
  const double* x = columns_ ? image.along.data() : image.across.data();
  lines_.clear();
  line_begin_.assign(1, 0);
  segment_of_.resize(static_cast<std::size_t>(scan_lines) * static_cast<std::size_t>(length));
  for (int i = 0; i < scan_lines; ++i) {
    const std::size_t start = static_cast<std::size_t>(i) * static_cast<std::size_t>(length);
    line_growing_.grow(w + start, weight + start, x, length, static_cast<std::int32_t>(lines_.size()), lines_,
                       segment_of_.data() + start);
    line_begin_.push_back(lines_.size());
  }
}

void DirectionalPlanes::growPlanes(const InverseDepthImage& image) {
  if (!active_) return;
  plane_growing_.begin(pixelPitch(columns_ ? image.along : image.across));
  for (std::size_t i = 0; i + 1 < line_begin_.size(); ++i) {
    ScanLineRays rays;
    if (columns_)
      rays = {{image.across[i], 0.0, image.forward[i]}, Eigen::Vector3d::UnitY()};
    else
      rays = {{0.0, image.along[i], 1.0}, Eigen::Vector3d::UnitX()};
    plane_growing_.addLine(rays, lines_.data() + line_begin_[i], line_begin_[i + 1] - line_begin_[i]);
  }
  plane_points_.clear();
  for (const GrownPlane& plane : plane_growing_.planes()) {
    const bool large_enough = plane.moments.n >= parameters_.min_points && plane.segments >= parameters_.min_segments;
    plane_points_.push_back(large_enough ? plane.moments.n : 0.0);
  }
}

}  // namespace epcc
