// SPDX-License-Identifier: BSD-3-Clause
// Rays meet planes; what would be beyond the horizon stays near what was measured.
#include "geometry/outline_planes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace epcc {

namespace {
/// A corner is at most this many times as far away as the farthest pixel of its region.
constexpr double kFarthestCorner = 2.0;
/// Sine of the angle to the vertical below which a normal gives no horizontal direction.
constexpr double kLying = 0.2;
constexpr double kTinyWeight = 1e-9;

Eigen::Vector3d direction(const DepthFrame& frame, const Eigen::Vector3d& of_scan) {
  return frame.fromScan(of_scan) - frame.fromScan(Eigen::Vector3d::Zero());
}
}  // namespace

PlaneBasis planeBasis(const DepthFrame& frame, const Plane& plane) {
  PlaneBasis basis;
  const double sensor_side = plane.signedDistance(frame.fromScan(Eigen::Vector3d::Zero()));
  const Eigen::Vector3d normal = (sensor_side < 0.0 ? -1.0 : 1.0) * plane.coefficients.head<3>();
  const Eigen::Vector3d horizontal = direction(frame, -Eigen::Vector3d::UnitY()).cross(normal);
  const Eigen::Vector3d right = direction(frame, Eigen::Vector3d::UnitX());
  const bool lies = horizontal.norm() < kLying;
  const Eigen::Vector3d across = (lies ? Eigen::Vector3d(right - right.dot(normal) * normal) : horizontal).normalized();
  basis.normal = normal;
  basis.across = across;
  basis.up = normal.cross(across);
  basis.origin = plane.project(plane.centroid);
  return basis;
}

OutlinePlanes::OutlinePlanes(const PixelRays& rays, const DepthFrame& frame, const PlaneSegmentation& segmentation,
                             const std::vector<std::int32_t>& labels, OutlinePlacement placement)
    : rays_(rays), labels_(labels), placement_(placement) {
  Eigen::Matrix3d axes;
  const Eigen::Vector3d origin = frame.fromScan(Eigen::Vector3d::Zero());
  for (int k = 0; k < 3; ++k) axes.col(k) = direction(frame, Eigen::Vector3d::Unit(k));
  for (const Plane& plane : segmentation.planes) {
    Eigen::Vector3d q;
    const bool exists = rays.inverseDepthPlane(plane, q);
    q_.push_back(exists ? std::optional<Eigen::Vector3d>(q) : std::nullopt);
    const PlaneBasis basis = planeBasis(frame, plane);
    FlatMap map;
    map.turn << basis.across.transpose() * axes, basis.up.transpose() * axes;
    map.shift = basis.flat(origin);
    bases_.push_back(basis);
    maps_.push_back(map);
  }
  measureRegions();
}

void OutlinePlanes::measureRegions() {
  pixel_areas_.assign(q_.size(), 0.0);
  least_w_.assign(q_.size(), std::numeric_limits<double>::infinity());
  std::vector<double> lengths;  // of q
  for (const auto& own : q_) lengths.push_back(own ? own->norm() : 0.0);
  for (int row = 0; row < rays_.height(); ++row)
    for (int column = 0; column < rays_.width(); ++column) {
      const std::int32_t label = labels_[rays_.index(row, column)];
      if (label <= 0 || !exists(label)) continue;
      const auto i = static_cast<std::size_t>(label - 1);
      const auto measured = static_cast<double>(rays_.measured(row, column));
      const double w = q(label).dot(rays_.ray(column, row));
      if (measured > 0.0) least_w_[i] = std::min(least_w_[i], std::max(w, measured));
      if (w > kTinyWeight) pixel_areas_[i] += rays_.pixelDeterminant(column, row) * lengths[i] / (w * w * w);
    }
  for (double& w : least_w_) w = std::isfinite(w) ? w / kFarthestCorner : kTinyWeight;
}

/// Mean of what the region's pixels around the corner measured, 0 if none did.
double OutlinePlanes::measuredAt(int label, int row, int column) const {
  double sum = 0.0, count = 0.0;
  for (int r = std::max(0, row - 1); r <= std::min(row, rays_.height() - 1); ++r)
    for (int c = column - 1; c <= column; ++c) {
      int own = c;
      if (rays_.closesRound()) own = c < 0 ? c + rays_.width() : c >= rays_.width() ? c - rays_.width() : c;
      if (own < 0 || own >= rays_.width() || labels_[rays_.index(r, own)] != label) continue;
      const float w = rays_.measured(r, own);
      if (!(w > 0.0f)) continue;
      sum += static_cast<double>(w);
      count += 1.0;
    }
  return count > 0.0 ? sum / count : 0.0;
}

Eigen::Vector3d OutlinePlanes::corner(int label, int row, int column, const Eigen::Vector2d& shift) const {
  const Eigen::Vector3d ray = rays_.ray(column - 0.5 + shift.x(), row - 0.5 + shift.y());
  const Eigen::Vector3d& own = q(label);
  const double on_plane = own.dot(ray);
  double w = std::max(on_plane, least_w_[static_cast<std::size_t>(label - 1)]);
  if (placement_ == OutlinePlacement::Orthogonal) {
    const double measured = measuredAt(label, row, column);
    if (measured > 0.0) w = measured;
  }
  const Eigen::Vector3d point = ray / w;
  return point + (1.0 - own.dot(point)) / own.squaredNorm() * own;
}

Eigen::Vector2d OutlinePlanes::flat(int label, const Eigen::Vector3d& scan_point) const {
  const FlatMap& map = maps_[static_cast<std::size_t>(label - 1)];
  return map.turn * scan_point + map.shift;
}

}  // namespace epcc
