// SPDX-License-Identifier: BSD-3-Clause
// The direct linear transformation, weighted anew by the depths it finds and without the points it does not fit, and
// the matrix taken apart.
#include "geometry/resectioning.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <vector>

#include "quantile.h"

namespace epcc {

namespace {

constexpr int kPasses = 4;
constexpr double kFewest = 24.0;  // points
// A point that is off by so many times the median is none of the camera's; and so much, in half images, is never.
constexpr double kOutlier = 6.0;
constexpr double kExact = 1e-6;
// The camera is at most so many times the size of the cloud away: seen from farther, rays are parallel.
constexpr double kFarthestOrigin = 1e3;

/// Pixels and points in numbers near one.
struct Normalization {
  double pixel_scale = 1.0, column = 0.0, row = 0.0;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  double size = 1.0;

  Normalization(const PointLattice& lattice, bool keeps_origin) {
    column = 0.5 * (lattice.columns().front() + lattice.columns().back());
    row = 0.5 * (lattice.rows().front() + lattice.rows().back());
    pixel_scale = 2.0 / std::max({1, lattice.columns().back() - lattice.columns().front(),
                                  lattice.rows().back() - lattice.rows().front()});
    const double n = static_cast<double>(lattice.points().size());
    if (!keeps_origin) {
      for (const PointLattice::Point& point : lattice.points()) centre += point.p;
      centre /= n;
    }
    double sum = 0.0;
    for (const PointLattice::Point& point : lattice.points()) sum += (point.p - centre).norm();
    if (sum > 0.0) size = sum / n;
  }
  double u(const PointLattice& lattice, const PointLattice::Point& point) const {
    return pixel_scale * (lattice.columns()[static_cast<std::size_t>(point.column)] - column);
  }
  double v(const PointLattice& lattice, const PointLattice::Point& point) const {
    return pixel_scale * (lattice.rows()[static_cast<std::size_t>(point.row)] - row);
  }
};

/// The sums of y y^T, times 1, u, v and u^2 + v^2.
template <int D>
struct LinearSystem {
  using Block = Eigen::Matrix<double, D, D>;
  Block plain = Block::Zero(), by_u = Block::Zero(), by_v = Block::Zero(), by_squares = Block::Zero();

  void add(double weight, double u, double v, const Eigen::Matrix<double, D, 1>& y) {
    const Block square = weight * y * y.transpose();
    plain += square;
    by_u += u * square;
    by_v += v * square;
    by_squares += (u * u + v * v) * square;
  }
  /// P with the smallest sum of |(P1 - u P3) y|^2 + |(P2 - v P3) y|^2, of norm one.
  Eigen::Matrix<double, 3, D> solve() const {
    Eigen::Matrix<double, 3 * D, 3 * D> m = Eigen::Matrix<double, 3 * D, 3 * D>::Zero();
    m.template block<D, D>(0, 0) = plain;
    m.template block<D, D>(D, D) = plain;
    m.template block<D, D>(2 * D, 2 * D) = by_squares;
    m.template block<D, D>(0, 2 * D) = -by_u;
    m.template block<D, D>(2 * D, 0) = -by_u;
    m.template block<D, D>(D, 2 * D) = -by_v;
    m.template block<D, D>(2 * D, D) = -by_v;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 3 * D, 3 * D>> solver(m);
    Eigen::Matrix<double, 3, D> p;
    for (int row = 0; row < 3; ++row)
      p.row(row) = solver.eigenvectors().col(0).template segment<D>(D * row).transpose();
    return p;
  }
};

template <int D>
Eigen::Matrix<double, D, 1> homogeneous(const Eigen::Vector3d& p) {
  Eigen::Matrix<double, D, 1> y;
  if constexpr (D == 4)
    y << p, 1.0;
  else
    y = p.normalized();
  return y;
}

/// M = K R with K upper triangular and of positive diagonal, R orthogonal; the rows of R.
Eigen::Matrix3d cameraAxes(const Eigen::Matrix3d& m) {
  Eigen::Matrix3d turned;  // the rows of M from the last to the first, as columns
  for (int k = 0; k < 3; ++k) turned.col(k) = m.row(2 - k).transpose();
  const Eigen::HouseholderQR<Eigen::Matrix3d> qr(turned);
  const Eigen::Matrix3d q = qr.householderQ();
  Eigen::Matrix3d axes;
  for (int k = 0; k < 3; ++k) axes.col(2 - k) = qr.matrixQR()(k, k) < 0.0 ? Eigen::Vector3d(-q.col(k)) : q.col(k);
  return axes;
}

/// The matrix from a lattice's points to its pixels.
template <int D>
class Camera {
 public:
  explicit Camera(const PointLattice& lattice) : lattice_(lattice), normal_(lattice, D == 3) {}

  std::optional<PoseHypothesis> pose() {
    errors_.assign(lattice_.points().size(), 0.0);
    for (int pass = 0; pass < kPasses; ++pass)
      if (!solve(pass == 0) || !measureErrors()) return std::nullopt;
    return takenApart();
  }

 private:
  Eigen::Matrix<double, D, 1> point(std::size_t i) const {
    return homogeneous<D>((lattice_.points()[i].p - normal_.centre) / normal_.size);
  }

  /// An error of the image counts as much at any depth, which is known from the second pass on.
  bool solve(bool is_first) {
    LinearSystem<D> system;
    double used = 0.0;
    for (std::size_t i = 0; i < errors_.size(); ++i) {
      if (!(errors_[i] <= limit_)) continue;
      const Eigen::Matrix<double, D, 1> y = point(i);
      const double depth = is_first ? 1.0 : p_.row(2).dot(y);
      const PointLattice::Point& at = lattice_.points()[i];
      system.add(1.0 / std::max(depth * depth, 1e-12), normal_.u(lattice_, at), normal_.v(lattice_, at), y);
      used += 1.0;
    }
    if (used < kFewest) return false;
    p_ = system.solve();
    double in_front = 0.0;
    for (std::size_t i = 0; i < errors_.size(); ++i) in_front += p_.row(2).dot(point(i)) > 0.0 ? 1.0 : -1.0;
    if (in_front < 0.0) p_ = -p_;
    return true;
  }

  bool measureErrors() {
    for (std::size_t i = 0; i < errors_.size(); ++i) {
      const PointLattice::Point& at = lattice_.points()[i];
      const Eigen::Vector3d image = p_ * point(i);
      errors_[i] = image.z() > 0.0 ? std::hypot(image.x() / image.z() - normal_.u(lattice_, at),
                                                image.y() / image.z() - normal_.v(lattice_, at))
                                   : std::numeric_limits<double>::infinity();
    }
    sorted_ = errors_;
    const double middle = median(sorted_);
    limit_ = std::max(kOutlier * middle, kExact);
    return std::isfinite(middle);
  }

  std::optional<PoseHypothesis> takenApart() const {
    const Eigen::Matrix3d m = p_.template leftCols<3>();
    if (!(std::abs(m.determinant()) > 1e-15 * std::pow(m.norm(), 3.0))) return std::nullopt;
    PoseHypothesis pose;
    pose.axes = cameraAxes(m);
    if constexpr (D == 4) {
      const Eigen::Vector3d origin = -m.inverse() * p_.col(3);
      if (!(origin.norm() < kFarthestOrigin)) return std::nullopt;
      pose.origin = normal_.centre + normal_.size * origin;
    }
    return pose.axes.allFinite() && pose.origin.allFinite() ? std::optional<PoseHypothesis>(pose) : std::nullopt;
  }

  const PointLattice& lattice_;
  Normalization normal_;
  Eigen::Matrix<double, 3, D> p_ = Eigen::Matrix<double, 3, D>::Zero();
  double limit_ = std::numeric_limits<double>::infinity();
  std::vector<double> errors_, sorted_;
};

}  // namespace

std::optional<PoseHypothesis> cameraAnywhere(const PointLattice& lattice) {
  return Camera<4>(lattice).pose();
}

std::optional<PoseHypothesis> cameraAtOrigin(const PointLattice& lattice) {
  return Camera<3>(lattice).pose();
}

}  // namespace epcc
