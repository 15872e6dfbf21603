// SPDX-License-Identifier: BSD-3-Clause
// Depths, ranges and points of scan lines -> samples in the scan frame.
#include "stream/collected_strip.h"

#include <algorithm>
#include <cmath>

#include "cloud_points.h"

namespace epcc {

namespace {

float secantOf(double u) {
  return static_cast<float>(std::sqrt(1.0 + u * u));
}

/// The scan frame (across, along, forward) in the sensor's own.
Eigen::Matrix3d scanAxes(Projection projection) {
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  if (projection == Projection::PerspectiveBackward) axes.diagonal() << 1.0, -1.0, -1.0;
  if (projection == Projection::Spherical) axes << 0.0, 0.0, 1.0, -1.0, 0.0, 0.0, 0.0, -1.0, 0.0;
  return axes;
}

bool isNear(float coordinate) {
  return std::abs(coordinate) <= kFarthest;
}

}  // namespace

void CollectedStrip::begin(const StreamGeometry& geometry) {
  using Kind = StreamGeometry::Kind;
  z_only_ = geometry.kind() == Kind::CameraColumns || geometry.kind() == Kind::CameraRows;
  projection_ = geometry.projection();
  depth_is_range_ = !isPerspective(projection_);
  height_ = static_cast<std::size_t>(geometry.height());
  pitch_ = height_ + kRunLanes;
  size_ = 0;
  lines_.assign((z_only_ ? 1 : 3) * kStripLines * pitch_, 0.0f);
  side_by_side_.assign((z_only_ ? 1 : 3) * kStripLines * height_, 0.0f);
  axes_ = scanAxes(projection_);
  cosine_.clear();
  sine_.clear();
  for (const double elevation : geometry.elevations()) {
    cosine_.push_back(std::cos(elevation));
    sine_.push_back(std::sin(elevation));
  }
  if (!z_only_) return;
  const PinholeCamera& camera = geometry.camera();
  const bool columns = geometry.kind() == Kind::CameraColumns;
  focus_ = columns ? camera.fx : camera.fy;
  centre_ = columns ? camera.cx : camera.cy;
  along_exact_.assign(pitch_, 0.0);
  along_.resize(height_);
  for (std::size_t i = 0; i < height_; ++i) {
    const auto place = static_cast<double>(i);
    along_exact_[i] = columns ? (place - camera.cy) / camera.fy : (place - camera.cx) / camera.fx;
    along_[i] = static_cast<float>(along_exact_[i]);
  }
  if (columns) axes_ << 0.0, 1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0;  // sums have the place in the line first
  largest_slope_ = std::max(std::abs(along_.front()), std::abs(along_.back()));
  for (const int line : {0, geometry.lineCount() - 1})
    if (geometry.lineCount() > 0)
      largest_slope_ = std::max(largest_slope_, static_cast<double>(secantOf((line - centre_) / focus_)));
}

void CollectedStrip::addDepths(std::int64_t index, const float* depth, std::ptrdiff_t stride) {
  const double u = (static_cast<double>(index) - centre_) / focus_;
  across_[size_] = u;
  secant_[size_] = secantOf(u);
  const float farthest = farthestDepth(std::max(static_cast<float>(largest_slope_), secant_[size_]));
  float* z = line(0);
  for (std::size_t i = 0; i < height_; ++i, depth += stride) z[i] = *depth > 0.0f && *depth <= farthest ? *depth : 0.0f;
  ++size_;
}

void CollectedStrip::addRanges(double azimuth, const float* ranges, std::ptrdiff_t stride) {
  const double ahead = std::cos(azimuth), left = std::sin(azimuth);
  float *x = line(0), *y = line(1), *z = line(2);
  for (std::size_t i = 0; i < height_; ++i, ranges += stride) {
    const auto range = static_cast<double>(*ranges);
    x[i] = -static_cast<float>(range * cosine_[i] * left);
    y[i] = -static_cast<float>(range * sine_[i]);
    z[i] = static_cast<float>(range * cosine_[i] * ahead);
    if (*ranges > 0.0f && isNear(x[i]) && isNear(y[i]) && isNear(z[i])) continue;
    x[i] = y[i] = z[i] = 0.0f;
  }
  ++size_;
}

void CollectedStrip::addPoints(const float* xyz, std::ptrdiff_t stride) {
  const int height = static_cast<int>(height_);
  const DepthFrame column = DepthFrame::fromPoints(xyz, static_cast<std::size_t>(stride), 1, height, projection_);
  readScanPoints(column, {0, height, 0, 1, 1}, kFarthest, {line(0), line(1), line(2), 1});
  ++size_;
}

void CollectedStrip::laySideBySide(int coordinate) {
  float* to = side(coordinate);
  for (int i = 0; i < size_; ++i) {
    const float* from = line(coordinate, i);
    for (std::size_t row = 0; row < height_; ++row) to[row * kStripLines + static_cast<std::size_t>(i)] = from[row];
  }
  if (size_ == kStripLines) return;
  for (std::size_t row = 0; row < height_; ++row)
    std::fill(to + row * kStripLines + size_, to + (row + 1) * kStripLines, 0.0f);
}

ScanStrip CollectedStrip::strip() {
  ScanStrip strip;
  strip.height = static_cast<int>(height_);
  strip.stride = kStripLines;
  if (z_only_) {
    laySideBySide(0);
    strip.z = side(0);
    strip.secant = secant_;
    strip.along = along_.data();
    return strip;
  }
  for (int coordinate = 0; coordinate < 3; ++coordinate) laySideBySide(coordinate);
  strip.x = side(0);
  strip.y = side(1);
  strip.z = side(2);
  strip.depth_is_range = depth_is_range_;
  return strip;
}

Eigen::Vector3d CollectedStrip::direction(int line, const float* sum) const {
  if (z_only_) return Eigen::Vector3d(across_[line], 0.0, 1.0).normalized();
  return Eigen::Vector3d(sum[0], 0.0, sum[1]).normalized();
}

SampleRow CollectedStrip::row(int i) const {
  SampleRow row;
  row.count = height_;
  if (z_only_) {
    row.z = line(0, i);
    row.across = along_exact_.data();
    row.along = across_[i];
    return row;
  }
  row.x = line(0, i);
  row.y = line(1, i);
  row.z = line(2, i);
  row.depth_is_range = depth_is_range_;
  return row;
}

}  // namespace epcc
