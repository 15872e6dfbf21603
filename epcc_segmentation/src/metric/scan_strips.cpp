// SPDX-License-Identifier: BSD-3-Clause
// Reads depth images row by row, transposed ones and clouds strip by strip.
#include "metric/scan_strips.h"

#include <algorithm>
#include <cmath>

#include "cloud_points.h"

namespace epcc {

namespace {

/// What is too far for single precision is not measured.
void dropFarthest(float* depth, std::size_t count, float farthest) {
  for (std::size_t i = 0; i < count; ++i) depth[i] = depth[i] <= farthest ? depth[i] : 0.0f;
}

}  // namespace

void ScanStrips::begin(const DepthFrame& view) {
  const auto width = static_cast<std::size_t>(view.width());
  height_ = view.height();
  padded_ = (width + kStripLines - 1) / kStripLines * kStripLines;
  has_depth_ = view.isPinhole() && !view.isTransposed();
  if (!view.isPinhole()) return;
  secant_.assign(padded_, 1.0f);
  for (std::size_t c = 0; c < width; ++c) {
    const double u = view.pinholeAcross(static_cast<int>(c));
    secant_[c] = static_cast<float>(std::sqrt(1.0 + u * u));
  }
  along_.resize(static_cast<std::size_t>(height_));
  for (int r = 0; r < height_; ++r) along_[static_cast<std::size_t>(r)] = static_cast<float>(view.pinholeAlong(r));
  float slope = std::max(std::abs(along_.front()), std::abs(along_.back()));
  for (const float secant : secant_) slope = std::max(slope, secant);
  farthest_ = farthestDepth(slope);
  if (!has_depth_) return;
  depth_.resize(static_cast<std::size_t>(height_) * padded_);
  for (int r = 0; r < height_; ++r) {  // a tenth of a millisecond: threads would not pay
    float* row = depth_.data() + static_cast<std::size_t>(r) * padded_;
    view.depthRow(r, row);
    dropFarthest(row, width, farthest_);
    std::fill(row + width, row + padded_, 0.0f);
  }
}

ScanStrip ScanStrips::strip(const DepthFrame& view, int strip, std::vector<float>& memory) const {
  if (!view.isPinhole()) return fromPoints(view, strip, memory);
  return view.isTransposed() ? fromRows(view, strip, memory) : fromImage(strip);
}

ScanStrip ScanStrips::fromImage(int strip) const {
  ScanStrip result;
  const int first = strip * kStripLines;
  result.height = height_;
  result.stride = padded_;
  result.z = depth_.data() + first;
  result.secant = secant_.data() + first;
  result.along = along_.data();
  return result;
}

// The view's columns are rows in memory: each is read whole and laid beside the others.
ScanStrip ScanStrips::fromRows(const DepthFrame& view, int strip, std::vector<float>& memory) const {
  const DepthFrame image = view.transposed();
  const auto height = static_cast<std::size_t>(height_);
  const int first = strip * kStripLines;
  const int lines = std::min(kStripLines, view.width() - first);
  memory.resize((height + 1) * kStripLines + height);
  float* z = memory.data();
  float* line = z + height * kStripLines;
  if (lines < kStripLines) std::fill(z, line, 0.0f);
  for (int i = 0; i < lines; ++i) {
    image.depthRow(first + i, line);
    dropFarthest(line, height, farthest_);
    for (std::size_t r = 0; r < height; ++r) z[r * kStripLines + static_cast<std::size_t>(i)] = line[r];
  }
  ScanStrip result;
  result.height = height_;
  result.stride = kStripLines;
  result.z = z;
  result.secant = secant_.data() + first;
  result.along = along_.data();
  return result;
}

ScanStrip ScanStrips::fromPoints(const DepthFrame& view, int strip, std::vector<float>& memory) const {
  const std::size_t size = static_cast<std::size_t>(height_) * kStripLines;
  const int first = strip * kStripLines;
  const int lines = std::min(kStripLines, view.width() - first);
  memory.resize(3 * size);
  float* x = memory.data();
  float* y = x + size;
  float* z = y + size;
  if (lines < kStripLines) std::fill(memory.begin(), memory.end(), 0.0f);
  readScanPoints(view, {0, height_, first, lines, 1}, kFarthest, {x, y, z, kStripLines});
  ScanStrip result;
  result.height = height_;
  result.stride = kStripLines;
  result.x = x;
  result.y = y;
  result.z = z;
  result.depth_is_range = !isPerspective(view.projection());
  return result;
}

Eigen::Vector3d ScanStrips::direction(const DepthFrame& view, int column, const float* sum) const {
  if (!view.isPinhole()) return Eigen::Vector3d(sum[0], 0.0, sum[1]).normalized();
  return Eigen::Vector3d(view.pinholeAcross(column), 0.0, 1.0).normalized();
}

}  // namespace epcc
