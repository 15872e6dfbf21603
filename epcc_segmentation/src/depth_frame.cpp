// SPDX-License-Identifier: BSD-3-Clause
// Access to the points of the three kinds of organized measurement.
#include "epcc_segmentation/depth_frame.h"

#include <cmath>
#include <limits>

namespace epcc {

std::string PinholeCamera::validate() const {
  if (width <= 0 || height <= 0) return "the image size must be positive";
  if (!(std::isfinite(fx) && fx > 0.0) || !(std::isfinite(fy) && fy > 0.0)) return "fx and fy must be positive";
  if (!std::isfinite(cx) || !std::isfinite(cy)) return "cx and cy must be finite";
  return {};
}

DepthFrame DepthFrame::fromDepth(const float* depth, const PinholeCamera& camera) {
  DepthFrame frame;
  if (depth == nullptr || !camera.validate().empty()) return frame;
  frame.depth_ = depth;
  frame.camera_ = camera;
  frame.width_ = camera.width;
  frame.height_ = camera.height;
  frame.row_stride_ = static_cast<std::size_t>(camera.width);
  frame.column_stride_ = 1;
  return frame;
}

DepthFrame DepthFrame::fromPoints(const float* xyz, std::size_t stride, int width, int height, Projection projection) {
  DepthFrame frame;
  if (xyz == nullptr || stride < 3 || width <= 0 || height <= 0) return frame;
  frame.xyz_ = xyz;
  frame.point_stride_ = stride;
  frame.width_ = width;
  frame.height_ = height;
  frame.row_stride_ = static_cast<std::size_t>(width);
  frame.column_stride_ = 1;
  frame.projection_ = projection;
  return frame;
}

DepthFrame DepthFrame::masked(const std::uint8_t* mask) const {
  DepthFrame frame = *this;
  frame.mask_ = mask;
  return frame;
}

DepthFrame DepthFrame::transposed() const {
  DepthFrame frame = *this;
  std::swap(frame.width_, frame.height_);
  std::swap(frame.row_stride_, frame.column_stride_);
  frame.transposed_ = !transposed_;
  return frame;
}

void DepthFrame::depthRow(int row, float* depth) const {
  const std::size_t start = index(row, 0);
  for (int c = 0; c < width_; ++c) {
    const float z = depth_[start + static_cast<std::size_t>(c) * column_stride_];
    depth[c] = z > 0.0f && z <= std::numeric_limits<float>::max() ? z : 0.0f;
  }
  if (mask_ == nullptr) return;
  for (int c = 0; c < width_; ++c)
    if (mask_[start + static_cast<std::size_t>(c) * column_stride_] == 0) depth[c] = 0.0f;
}

Projection detectProjection(const float* xyz, std::size_t stride, int width, int height) {
  // Sum over neighbouring valid points of a column of the change of each candidate's column angle.
  double perspective_change = 0.0;
  double spherical_change = 0.0;
  long pairs = 0;
  long points = 0;
  long behind = 0;
  const int column_step = width > 64 ? width / 64 : 1;
  for (int column = 0; column < width; column += column_step) {
    bool have_last = false;
    double last_perspective = 0.0;
    double last_spherical = 0.0;
    for (int row = 0; row < height; ++row) {
      const float* p = xyz + (static_cast<std::size_t>(row) * width + column) * stride;
      if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2])) continue;
      const double x = static_cast<double>(p[0]);
      const double y = static_cast<double>(p[1]);
      const double z = static_cast<double>(p[2]);
      if (x == 0.0 && y == 0.0 && z == 0.0) continue;
      ++points;
      if (z <= 0.0) ++behind;
      const double perspective_angle = std::atan2(x, z);
      const double spherical_angle = std::atan2(y, x);
      if (have_last) {
        perspective_change += std::abs(std::remainder(perspective_angle - last_perspective, 2.0 * M_PI));
        spherical_change += std::abs(std::remainder(spherical_angle - last_spherical, 2.0 * M_PI));
        ++pairs;
      }
      last_perspective = perspective_angle;
      last_spherical = spherical_angle;
      have_last = true;
    }
  }
  // A camera sees one side of z = 0 only; ten times clearer is clear enough.
  const Projection perspective = 2 * behind > points ? Projection::PerspectiveBackward : Projection::Perspective;
  if (pairs < 16) return Projection::Perspective;
  if ((behind == 0 || behind == points) && spherical_change > 0.1 * perspective_change) return perspective;
  return spherical_change < perspective_change ? Projection::Spherical : perspective;
}

}  // namespace epcc
