// SPDX-License-Identifier: BSD-3-Clause
// A rigid transform of points there and of planes back, by the table of rings.
#include "geometry/sensor_cloud.h"

#include <algorithm>
#include <limits>

#include "geometry/rigid_map.h"
#include "parallel_for.h"
#include "symmetric_part.h"

namespace epcc {

namespace {

constexpr std::size_t kNoPixel = std::numeric_limits<std::size_t>::max();

}  // namespace

std::size_t SensorCloud::callersPixel(int row, int column) const {
  const ScanGrid& grid = geometry_.grid;
  const auto at = static_cast<std::size_t>(row);
  const int ring = grid.ring_order.empty() ? row : grid.ring_order[at];
  const int columns = grid.rings_are_columns ? height_ : width_;
  if (!grid.ring_shift.empty()) {
    column += grid.ring_shift[static_cast<std::size_t>(ring)];
    if (grid.closes_round) column = ((column % columns) + columns) % columns;
    if (column < 0 || column >= columns) return kNoPixel;
  }
  const int callers_row = grid.rings_are_columns ? column : ring;
  const int callers_column = grid.rings_are_columns ? ring : column;
  return static_cast<std::size_t>(callers_row) * static_cast<std::size_t>(width_) +
         static_cast<std::size_t>(callers_column);
}

void SensorCloud::copyRow(const DepthFrame& frame, int row, float* to) const {
  const RigidMap map(geometry_);
  const float* points = frame.points();
  const std::size_t stride = frame.pointStride();
  const bool is_plain_order =
      geometry_.grid.ring_order.empty() && geometry_.grid.ring_shift.empty() && !geometry_.grid.rings_are_columns;
  const bool may_be_marked = !geometry_.invalid_points.empty() || frame.mask() != nullptr;
  constexpr float kNoPoint = std::numeric_limits<float>::quiet_NaN();
  for (int column = 0; column < columns_; ++column, to += 4) {
    const std::size_t pixel = is_plain_order ? static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) +
                                                   static_cast<std::size_t>(column)
                                             : callersPixel(row, column);
    to[0] = to[1] = to[2] = kNoPoint;
    to[3] = 1.0f;
    if (pixel == kNoPixel) continue;
    const float* p = points + stride * pixel;
    if (p[0] == 0.0f && p[1] == 0.0f && p[2] == 0.0f) continue;
    if (may_be_marked) {
      if (frame.mask() != nullptr && frame.mask()[pixel] == 0) continue;
      const auto isPoint = [p](const Vector3f& m) { return p[0] == m.x() && p[1] == m.y() && p[2] == m.z(); };
      if (std::any_of(geometry_.invalid_points.begin(), geometry_.invalid_points.end(), isPoint)) continue;
    }
    map.apply(p, to);
    if (!map.isMeasured(to)) to[2] = kNoPoint;
  }
}

DepthFrame SensorCloud::of(const DepthFrame& frame, int threads) {
  geometry_ = *frame.geometry();
  is_transposed_ = frame.isTransposed();
  const DepthFrame cloud = is_transposed_ ? frame.transposed() : frame;  // as it lies in the caller's memory
  width_ = cloud.width();
  height_ = cloud.height();
  columns_ = (geometry_.grid.rings_are_columns ? height_ : width_) + geometry_.grid.margin;
  rows_ = geometry_.grid.rings_are_columns ? width_ : height_;
  const std::size_t row_floats = 4 * static_cast<std::size_t>(columns_);
  points_.resize(row_floats * static_cast<std::size_t>(rows_));
  parallelFor(rows_, threads, [&](int, int begin, int end) {
    for (int row = begin; row < end; ++row)
      copyRow(cloud, row, points_.data() + row_floats * static_cast<std::size_t>(row));
  });
  DepthFrame own = DepthFrame::fromPoints(points_.data(), 4, columns_, rows_, geometry_.projection);
  if (geometry_.grid.closes_round) own = own.closedRound();
  return is_transposed_ ? own.transposed() : own;
}

void SensorCloud::takeLabels(const std::vector<std::int32_t>& labels, std::vector<std::int32_t>& own) const {
  own.clear();
  for (int row = 0; row < rows_; ++row)
    for (int column = 0; column < columns_; ++column) {
      const std::size_t pixel = callersPixel(row, column);
      own.push_back(pixel == kNoPixel ? 0 : labels[pixel]);
    }
}

void SensorCloud::giveBackLabels(PlaneSegmentation& result) {
  const bool is_plain_order = columns_ == width_ && geometry_.grid.ring_order.empty() &&
                              geometry_.grid.ring_shift.empty() && !geometry_.grid.rings_are_columns;
  result.width = is_transposed_ ? height_ : width_;
  result.height = is_transposed_ ? width_ : height_;
  if (is_plain_order) return;
  labels_.swap(result.labels);
  result.labels.assign(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), 0);
  std::size_t next = 0;
  for (int row = 0; row < rows_; ++row)
    for (int column = 0; column < columns_; ++column, ++next) {
      const std::size_t pixel = callersPixel(row, column);
      if (pixel != kNoPixel) result.labels[pixel] = labels_[next];
    }
}

void SensorCloud::giveBackSegments(PlaneSegmentation& result) const {
  const auto toCloud = [this](const Vector3& p) -> Vector3 { return geometry_.pose.axes * p + geometry_.pose.origin; };
  const auto row = [this](std::size_t pixel) { return static_cast<int>(pixel / static_cast<std::size_t>(width_)); };
  const auto column = [this](std::size_t pixel) { return static_cast<int>(pixel % static_cast<std::size_t>(width_)); };
  for (LineSegment& segment : result.segments) {
    segment.start = toCloud(segment.start);
    segment.end = toCloud(segment.end);
    if (geometry_.projection != Projection::Spherical) continue;
    std::size_t first = callersPixel(segment.first, segment.line);
    std::size_t last = callersPixel(segment.last, segment.line);
    // Rings may be stored from the lowest to the highest, or in no order: the end that the cloud has first is first.
    const bool rings_are_columns = geometry_.grid.rings_are_columns;
    if (rings_are_columns ? column(last) < column(first) : row(last) < row(first)) {
      std::swap(first, last);
      std::swap(segment.start, segment.end);
    }
    if (rings_are_columns) {
      segment.scan = ScanDirection::Rows;
      segment.line = row(first);
      segment.first = column(first);
      segment.last = column(last);
    } else {
      segment.line = column(first);
      segment.first = row(first);
      segment.last = row(last);
    }
  }
}

void SensorCloud::giveBack(PlaneSegmentation& result) {
  giveBackLabels(result);
  for (Plane& plane : result.planes) plane = inCloudFrame(plane, geometry_.pose);
  giveBackSegments(result);
}

// n . s + d = 0 with s = axes^T (p - origin): the normal is turned, and d changes by what the origin is along it.
Plane inCloudFrame(const Plane& plane, const SensorPose& pose) {
  Plane own = plane;
  const Eigen::Vector3d normal = pose.axes * plane.coefficients.head<3>();
  own.coefficients << normal, plane.coefficients(3) - normal.dot(pose.origin);
  Eigen::Matrix4d turn = Eigen::Matrix4d::Zero();
  turn.topLeftCorner<3, 3>() = pose.axes;
  turn.bottomLeftCorner<1, 3>() = -pose.origin.transpose() * pose.axes;
  turn(3, 3) = 1.0;
  own.coefficients_covariance = symmetricPart(turn * plane.coefficients_covariance * turn.transpose());
  own.centroid = pose.axes * plane.centroid + pose.origin;
  own.points_covariance = symmetricPart(pose.axes * plane.points_covariance * pose.axes.transpose());
  return own;
}

}  // namespace epcc
