// SPDX-License-Identifier: BSD-3-Clause
// Ray tables from intrinsics or from the points themselves.
#include "geometry/pixel_rays.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace epcc {

namespace {

constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

/// Values that are missing lie on the line between their neighbours; those beyond the ends go on in the mean step.
std::vector<double> filled(std::vector<double> values) {
  std::vector<std::size_t> known;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!std::isnan(values[i])) known.push_back(i);
  if (known.empty()) return std::vector<double>(values.size(), 0.0);
  const std::size_t first = known.front(), last = known.back();
  const double step = last > first ? (values[last] - values[first]) / static_cast<double>(last - first) : 0.0;
  for (std::size_t i = 0; i < first; ++i) values[i] = values[first] - step * static_cast<double>(first - i);
  for (std::size_t i = last + 1; i < values.size(); ++i)
    values[i] = values[last] + step * static_cast<double>(i - last);
  for (std::size_t k = 1; k < known.size(); ++k) {
    const std::size_t a = known[k - 1], b = known[k];
    for (std::size_t i = a + 1; i < b; ++i)
      values[i] = values[a] + (values[b] - values[a]) * static_cast<double>(i - a) / static_cast<double>(b - a);
  }
  return values;
}

/// Angles that go on from one to the next, without jumps of a full turn.
void unwrap(std::vector<double>& angles) {
  double before = kNoValue;
  for (double& angle : angles) {
    if (std::isnan(angle)) continue;
    if (!std::isnan(before)) angle = before + std::remainder(angle - before, 2.0 * M_PI);
    before = angle;
  }
}

/// What is collected of one column or row.
struct MeanRay {
  double x = 0.0, z = 0.0, count = 0.0;
};

}  // namespace

RayTable::RayTable(std::vector<double> values) : values_(filled(std::move(values))) {
  if (values_.size() == 1) values_.push_back(values_.front());
}

std::size_t RayTable::interval(double place) const {
  const double last = static_cast<double>(values_.size() - 2);
  return static_cast<std::size_t>(std::clamp(std::floor(place), 0.0, last));
}

double RayTable::at(double place) const {
  const std::size_t i = interval(place);
  return values_[i] + (values_[i + 1] - values_[i]) * (place - static_cast<double>(i));
}

double RayTable::slope(double place) const {
  const std::size_t i = interval(place);
  return values_[i + 1] - values_[i];
}

PixelRays::PixelRays(const DepthFrame& frame) : frame_(frame), is_camera_(isPerspective(frame.projection())) {
  const CloudGeometry* geometry = frame.geometry();
  const bool turned = geometry != nullptr && geometry->grid.rings_are_columns;
  width_ = turned ? frame.height() : frame.width();
  height_ = turned ? frame.width() : frame.height();
  if (geometry != nullptr) width_ += geometry->grid.margin;
  closes_round_ = !is_camera_ && frame.closesRound();
  readRays();
}

std::size_t PixelRays::callersPixel(int row, int column) const {
  const CloudGeometry* geometry = frame_.geometry();
  if (geometry == nullptr) return frame_.index(row, column);
  const ScanGrid& grid = geometry->grid;
  const int ring = grid.ring_order.empty() ? row : grid.ring_order[static_cast<std::size_t>(row)];
  const int columns = width_ - grid.margin;
  if (!grid.ring_shift.empty()) {
    column += grid.ring_shift[static_cast<std::size_t>(ring)];
    if (grid.closes_round) column = ((column % columns) + columns) % columns;
  }
  if (column < 0 || column >= columns) return kNoPixel;
  return grid.rings_are_columns ? frame_.index(column, ring) : frame_.index(ring, column);
}

void PixelRays::readRays() {
  measured_.assign(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), 0.0f);
  std::vector<MeanRay> of_column(static_cast<std::size_t>(width_)), of_row(static_cast<std::size_t>(height_));
  const auto frame_width = static_cast<std::size_t>(frame_.width());
  Eigen::Vector3d p;
  for (int row = 0; row < height_; ++row) {
    for (int column = 0; column < width_; ++column) {
      int frame_row = row, frame_column = column;
      if (frame_.geometry() != nullptr) {
        const std::size_t pixel = callersPixel(row, column);
        if (pixel == kNoPixel) continue;
        frame_row = static_cast<int>(pixel / frame_width);
        frame_column = static_cast<int>(pixel % frame_width);
      }
      if (!frame_.scanPoint(frame_row, frame_column, p)) continue;
      const double forward = is_camera_ ? p.z() : std::hypot(p.x(), p.z());
      if (!(forward > 0.0)) continue;
      const double w = 1.0 / forward;
      measured_[index(row, column)] = static_cast<float>(w);
      MeanRay& c = of_column[static_cast<std::size_t>(column)];
      c.x += p.x() * w;
      c.z += p.z() * w;
      c.count += 1.0;
      MeanRay& r = of_row[static_cast<std::size_t>(row)];
      r.x += p.y() * w;
      r.count += 1.0;
    }
  }
  std::vector<double> across, along;
  for (int column = 0; column < width_; ++column) {
    const MeanRay& mean = of_column[static_cast<std::size_t>(column)];
    if (frame_.isPinhole())
      across.push_back(frame_.pinholeAcross(column));
    else if (mean.count > 0.0)
      across.push_back(is_camera_ ? mean.x / mean.count : std::atan2(mean.x, mean.z));
    else
      across.push_back(kNoValue);
  }
  for (int row = 0; row < height_; ++row) {
    const MeanRay& mean = of_row[static_cast<std::size_t>(row)];
    if (frame_.isPinhole())
      along.push_back(frame_.pinholeAlong(row));
    else
      along.push_back(mean.count > 0.0 ? mean.x / mean.count : kNoValue);
  }
  if (!is_camera_) unwrap(across);
  // A single row or column has a step all the same.
  if (frame_.isPinhole()) {
    across.push_back(frame_.pinholeAcross(width_));
    along.push_back(frame_.pinholeAlong(height_));
  }
  across_ = RayTable(std::move(across));
  along_ = RayTable(std::move(along));
  for (int column = 0; column < width_; ++column) {
    const Eigen::Vector3d centre = ray(static_cast<double>(column), 0.0);
    column_rays_.emplace_back(centre.x(), centre.z());
    column_steps_.push_back(std::abs(across_.at(column + 0.5) - across_.at(column - 0.5)));
  }
  for (int row = 0; row < height_; ++row) {
    row_rays_.push_back(along_.at(row));
    row_steps_.push_back(std::abs(along_.at(row + 0.5) - along_.at(row - 0.5)));
  }
}

Eigen::Vector3d PixelRays::ray(double column, double row) const {
  const double across = across_.at(column), along = along_.at(row);
  if (is_camera_) return {across, along, 1.0};
  return {std::sin(across), along, std::cos(across)};
}

Eigen::Vector3d PixelRays::rayByColumn(double column) const {
  const double slope = across_.slope(column);
  if (is_camera_) return {slope, 0.0, 0.0};
  const double azimuth = across_.at(column);
  return {slope * std::cos(azimuth), 0.0, -slope * std::sin(azimuth)};
}

Eigen::Vector3d PixelRays::rayByRow(double row) const {
  return {0.0, along_.slope(row), 0.0};
}

bool PixelRays::inverseDepthPlane(const Plane& plane, Eigen::Vector3d& q) const {
  const Eigen::Vector3d origin = frame_.fromScan(Eigen::Vector3d::Zero());
  const Eigen::Vector3d normal = plane.coefficients.head<3>();
  const double distance = plane.signedDistance(origin);
  for (int k = 0; k < 3; ++k) q(k) = -normal.dot(frame_.fromScan(Eigen::Vector3d::Unit(k)) - origin) / distance;
  return q.allFinite() && q.squaredNorm() < 1e12;
}

std::vector<std::int32_t> PixelRays::scanLabels(const std::vector<std::int32_t>& labels, int count) const {
  std::vector<std::int32_t> own(measured_.size(), 0);
  for (int row = 0; row < height_; ++row)
    for (int column = 0; column < width_; ++column) {
      const std::size_t pixel = callersPixel(row, column);
      if (pixel == kNoPixel) continue;
      const std::int32_t label = labels[pixel];
      if (label > 0 && label <= count) own[index(row, column)] = label;
    }
  return own;
}

}  // namespace epcc
