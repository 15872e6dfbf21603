// SPDX-License-Identifier: BSD-3-Clause
// Planes are joined in three parameters about a place on them: two turns and an offset.
#include "over_time/track_state.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <cmath>
#include <limits>

#include "symmetric_part.h"

namespace epcc {

namespace {

/// Three parameters of a plane near another: turns about two axes on it, and the offset at a place.
struct LocalPlane {
  Eigen::Matrix<double, 3, 4> from_plane;  ///< of a change of (n, d)
  Eigen::Matrix<double, 4, 3> to_plane;

  LocalPlane(const Eigen::Vector3d& normal, const Eigen::Vector3d& place) {
    const Eigen::Vector3d x = normal.unitOrthogonal(), y = normal.cross(x);
    from_plane << x.transpose(), 0.0, y.transpose(), 0.0, place.transpose(), 1.0;
    to_plane << x, y, Eigen::Vector3d::Zero(), -x.dot(place), -y.dot(place), 1.0;
  }
};

/// A covariance as far as it is not above another one: what is not seen anew is not forgotten.
Eigen::Matrix3d notAbove(const Eigen::Matrix3d& limit, const Eigen::Matrix3d& covariance) {
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::Matrix3d> solver(symmetricPart(covariance), limit);
  const Eigen::Matrix3d axes = limit * solver.eigenvectors();  // v^T limit v = 1
  return axes * solver.eigenvalues().cwiseMax(0.0).cwiseMin(1.0).asDiagonal() * axes.transpose();
}

}  // namespace

SeenCells::SeenCells(const Eigen::Vector4d& plane, const Eigen::Vector3d& origin, double size)
    : origin_(origin), x_(plane.head<3>().unitOrthogonal()), y_(plane.head<3>().cross(x_)), size_(size) {}

SeenCells::Cell SeenCells::cellOf(const Eigen::Vector3d& point) const {
  const Eigen::Vector3d p = (point - origin_) / size_;
  return {static_cast<int>(std::floor(p.dot(x_))), static_cast<int>(std::floor(p.dot(y_)))};
}

Eigen::Vector3d SeenCells::pointOf(std::uint64_t key) const {
  const auto column = static_cast<std::int32_t>(key >> 32), row = static_cast<std::int32_t>(key & 0xffffffffU);
  return origin_ + size_ * ((column + 0.5) * x_ + (row + 0.5) * y_);
}

bool SeenCells::isNear(const Eigen::Vector3d& point) const {
  const Cell cell = cellOf(point);
  for (int i = -1; i <= 1; ++i)
    for (int j = -1; j <= 1; ++j)
      if (cells_.count(keyOf(cell + Cell(i, j))) > 0) return true;
  return false;
}

void SeenCells::join(const SeenCells& other) {
  for (const std::uint64_t key : other.cells_) add(other.pointOf(key));
}

void TrackState::join(const MapPlane& measured, const Eigen::Vector3d& place, double memory) {
  const Eigen::Vector4d before(plane.coefficients);
  const LocalPlane local(before.head<3>(), place);
  const Eigen::Matrix3d before_covariance =
      local.from_plane * Eigen::Matrix4d(plane.covariance) * local.from_plane.transpose();
  const Eigen::Matrix3d known = before_covariance * (memory / (memory - 1.0));
  const Eigen::Matrix3d seen = local.from_plane * Eigen::Matrix4d(measured.covariance) * local.from_plane.transpose();
  const Eigen::Matrix3d gain = known * (known + seen).ldlt().solve(Eigen::Matrix3d::Identity());
  const Eigen::Vector3d change = gain * local.from_plane * (Eigen::Vector4d(measured.coefficients) - before);
  Eigen::Vector4d after = before + local.to_plane * change;
  after /= after.head<3>().norm();
  const Eigen::Matrix3d rest = notAbove(before_covariance, (Eigen::Matrix3d::Identity() - gain) * known);
  const LocalPlane now(after.head<3>(), place);
  plane.coefficients = after;
  plane.covariance = symmetricPart(now.to_plane * rest * now.to_plane.transpose());
}

double squaredDifference(const MapPlane& a, const MapPlane& b, const Eigen::Vector3d& place) {
  if (a.coefficients.head<3>().dot(b.coefficients.head<3>()) <= 0.0) return std::numeric_limits<double>::infinity();
  const LocalPlane local(a.coefficients.head<3>(), place);
  const Eigen::Matrix3d covariance =
      local.from_plane * Eigen::Matrix4d(a.covariance + b.covariance) * local.from_plane.transpose();
  const Eigen::Vector3d difference = local.from_plane * Eigen::Vector4d(b.coefficients - a.coefficients);
  return difference.dot(covariance.ldlt().solve(difference));
}

}  // namespace epcc
