// SPDX-License-Identifier: BSD-3-Clause
// Views on depth images and organized clouds, checked when they are made.
#include "epcc_segmentation/depth_frame.h"

#include <cassert>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <type_traits>

#include "depth_range.h"
#include "depth_rows.h"
#include "geometry/rigid_map.h"

namespace epcc {

namespace {
// No camera is beyond these, and within them no sum of squares leaves the range of a double.
constexpr double kMinFocus = 1e-3;
constexpr double kMaxPixels = 1e6;
}  // namespace

std::string PinholeCamera::validate() const {
  if (width <= 0 || height <= 0) return "the image size must be positive";
  if (!(fx > 0.0) || !(fy > 0.0)) return "fx and fy must be positive";
  if (!(fx >= kMinFocus && fx <= kMaxPixels) || !(fy >= kMinFocus && fy <= kMaxPixels))
    return "fx and fy must be in [0.001, 1e6] pixels";
  if (!std::isfinite(cx) || !std::isfinite(cy)) return "cx and cy must be finite";
  if (std::abs(cx) > kMaxPixels || std::abs(cy) > kMaxPixels) return "cx and cy must be in [-1e6, 1e6] pixels";
  return {};
}

DepthFrame DepthFrame::unusable(Status status, const char* problem) {
  DepthFrame frame;
  frame.status_ = status;
  frame.problem_ = problem;
  return frame;
}

template <typename T>
DepthFrame DepthFrame::ofView(const DepthView<T>& depth, const PinholeCamera& camera) {
  if (depth.data == nullptr || depth.width <= 0 || depth.height <= 0)
    return unusable(Status::EmptyCloud, "the depth image is empty");
  if (!camera.validate().empty())
    return unusable(Status::InvalidCamera,
                    "the camera is invalid: fx and fy must be in [0.001, 1e6], cx and cy within 1e6 pixels");
  if (camera.width != depth.width || camera.height != depth.height)
    return unusable(Status::SizeMismatch, "the camera's size is not that of the depth image");
  const std::ptrdiff_t row_bytes = static_cast<std::ptrdiff_t>(depth.width) * static_cast<std::ptrdiff_t>(sizeof(T));
  const std::ptrdiff_t stride = depth.row_stride == 0 ? row_bytes : depth.row_stride;
  if (std::abs(stride) < row_bytes)
    return unusable(Status::SizeMismatch, "the depth image's row stride, in bytes, is less than a row");
  if (!(depth.scale > 0.0 && depth.scale <= kMaxDepthScale))
    return unusable(Status::InvalidCamera, "the depth image's scale must be positive, at most 1000 m a unit");
  DepthFrame frame;
  frame.setSize(depth.width, depth.height);
  frame.camera_ = camera;
  frame.depth_ = reinterpret_cast<const char*>(depth.data);
  frame.depth_is_float_ = std::is_same<T, float>::value;
  frame.depth_row_stride_ = stride;
  frame.depth_column_stride_ = static_cast<std::ptrdiff_t>(sizeof(T));
  frame.scale_ = depth.scale;
  return frame;
}

DepthFrame DepthFrame::fromDepth(const DepthView<float>& depth, const PinholeCamera& camera) {
  return ofView(depth, camera);
}

DepthFrame DepthFrame::fromDepth(const DepthView<std::uint16_t>& depth, const PinholeCamera& camera) {
  return ofView(depth, camera);
}

DepthFrame DepthFrame::fromDepth(const float* depth, const PinholeCamera& camera) {
  return ofView(DepthView<float>{depth, camera.width, camera.height}, camera);
}

Projection detectProjection(const float* xyz, std::size_t stride, int width, int height) {
  return findGeometry(xyz, stride, width, height).projection;
}

void DepthFrame::setSize(int width, int height) {
  status_ = Status::Ok;
  problem_ = "";
  width_ = width;
  height_ = height;
  row_stride_ = static_cast<std::size_t>(width);
  column_stride_ = 1;
}

DepthFrame DepthFrame::fromPoints(const float* xyz, std::size_t stride, int width, int height, Projection projection) {
  if (xyz == nullptr || width <= 0 || height <= 0) return unusable(Status::EmptyCloud, "the cloud is empty");
  if (stride < 3) return unusable(Status::SizeMismatch, "the cloud's points are less than three floats apart");
  DepthFrame frame;
  frame.setSize(width, height);
  frame.xyz_ = xyz;
  frame.point_stride_ = stride;
  frame.projection_ = projection;
  return frame;
}

DepthFrame DepthFrame::fromPoints(const float* xyz, std::size_t stride, int width, int height,
                                  const CloudGeometry& geometry) {
  DepthFrame frame = fromPoints(xyz, stride, width, height, geometry.projection);
  if (frame.empty()) return frame;
  if (geometry.status != Status::Ok) return unusable(geometry.status, geometry.problem.c_str());
  if (!geometry.is_plain || geometry.grid.rings_are_columns) frame.geometry_ = &geometry;
  frame.closes_round_ = geometry.grid.closes_round;
  return frame;
}

DepthFrame DepthFrame::readAs(const DepthOptions& options) const {
  if (depth_ != nullptr && !isDepthRange(options.min_depth, options.max_depth))
    return unusable(Status::InvalidParameters, kNoDepthRange);
  DepthFrame frame = *this;
  frame.options_ = options;
  frame.has_options_ = depth_ != nullptr;
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
  std::swap(frame.depth_row_stride_, frame.depth_column_stride_);
  frame.transposed_ = !transposed_;
  frame.closes_round_ = false;
  return frame;
}

DepthFrame DepthFrame::closedRound() const {
  DepthFrame frame = *this;
  frame.closes_round_ = true;
  return frame;
}

Eigen::Vector3d DepthFrame::fromScan(const Eigen::Vector3d& scan_point) const {
  Eigen::Vector3d p = scan_point;
  if (transposed_) std::swap(p.x(), p.y());
  if (projection_ == Projection::PerspectiveBackward) p = Eigen::Vector3d(p.x(), -p.y(), -p.z());
  if (projection_ == Projection::Spherical) p = Eigen::Vector3d(p.z(), -p.x(), -p.y());
  if (geometry_ != nullptr) p = geometry_->pose.axes * p + geometry_->pose.origin;
  return p;
}

// In the sensor's own frame, in metres.
bool DepthFrame::posedPoint(int row, int column, double& x, double& y, double& z) const {
  const float* p = xyz_ + index(row, column) * point_stride_;
  if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2])) return false;
  if (p[0] == 0.0f && p[1] == 0.0f && p[2] == 0.0f) return false;
  for (const Vector3f& marker : geometry_->invalid_points)
    if (p[0] == marker.x() && p[1] == marker.y() && p[2] == marker.z()) return false;
  float about[3];
  const RigidMap map(*geometry_);
  map.apply(p, about);
  if (!map.isMeasured(about)) return false;
  const Eigen::Vector3d metres = geometry_->unit * Vector3f(p[0], p[1], p[2]).cast<double>();
  const Eigen::Vector3d s = geometry_->pose.axes.transpose() * (metres - geometry_->pose.origin);
  x = s.x();
  y = s.y();
  z = s.z();
  return true;
}

template <typename T>
void DepthFrame::readRow(int row, float* depth) const {
  const char* values = depth_ + row * depth_row_stride_;
  const bool adjoining = depth_column_stride_ == static_cast<std::ptrdiff_t>(sizeof(T));
  if (adjoining && reinterpret_cast<std::uintptr_t>(values) % alignof(T) == 0)
    return depthsInMetres(reinterpret_cast<const T*>(values), static_cast<std::size_t>(width_), scale_, depth);
  for (int c = 0; c < width_; ++c) {
    T value;
    std::memcpy(&value, values + c * depth_column_stride_, sizeof value);
    const bool is_none = std::is_same<T, std::uint16_t>::value && value == static_cast<T>(kNoDepth);
    const auto z = is_none ? 0.0f : static_cast<float>(value * scale_);
    depth[c] = z > 0.0f && z <= std::numeric_limits<float>::max() ? z : 0.0f;
  }
}

// A depth in metres, as the image has it -> that of the options, 0 if it is none.
float DepthFrame::asRead(int row, int column, float depth) const {
  if (options_.invalid && depth == static_cast<float>(*options_.invalid * scale_)) return 0.0f;
  auto z = static_cast<double>(depth);
  if (options_.is_distance) {
    const double u = pinholeAcross(column), v = pinholeAlong(row);
    z /= std::sqrt(1.0 + u * u + v * v);
  }
  return z >= options_.min_depth && z <= options_.max_depth ? static_cast<float>(z) : 0.0f;
}

void DepthFrame::depthRow(int row, float* depth) const {
  assert(isPinhole());
  if (depth_is_float_)
    readRow<float>(row, depth);
  else
    readRow<std::uint16_t>(row, depth);
  if (has_options_)
    for (int c = 0; c < width_; ++c) depth[c] = asRead(row, c, depth[c]);
  if (mask_ == nullptr) return;
  for (int c = 0; c < width_; ++c)
    if (mask_[index(row, c)] == 0) depth[c] = 0.0f;
}

DepthView<std::uint16_t> DepthFrame::wholeNumbers() const {
  DepthView<std::uint16_t> image;
  if (depth_ == nullptr || depth_is_float_) return image;
  image.data = reinterpret_cast<const std::uint16_t*>(depth_);
  image.width = camera_.width;
  image.height = camera_.height;
  image.row_stride = transposed_ ? depth_column_stride_ : depth_row_stride_;
  image.scale = scale_;
  return image;
}

}  // namespace epcc
