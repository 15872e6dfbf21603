// SPDX-License-Identifier: BSD-3-Clause
// Additive moments of pixels in (ray, inverse depth), and the plane that fits them.
#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>

namespace epcc {

/// A plane q . ray = w with the inverse of its normal matrix.
struct PlaneEstimate {
  Eigen::Vector3d q = Eigen::Vector3d::Zero();
  Eigen::Matrix3d inverse = Eigen::Matrix3d::Zero();
  double rss = 0.0;  ///< weighted residual sum of squares, in units of sigma^2

  double at(const Eigen::Vector3d& ray) const { return q.dot(ray); }
};

/// The direction in which the columns of an image follow each other, as e e^T over the x and z of rays. A camera's is
/// x; a scanner's turns with the azimuth, so that a region has the mean over its pixels.
struct AcrossDirection {
  double xx = 1.0, xz = 0.0, zz = 0.0;

  AcrossDirection() = default;
  /// From sums of a scan's rays, whose x and z are a unit vector.
  AcrossDirection(double sum_xx, double sum_xz, double sum_zz) {
    const double scale = 1.0 / (sum_xx + sum_zz);
    xx = sum_zz * scale;
    xz = -sum_xz * scale;
    zz = sum_xx * scale;
  }
  /// (q . e)^2
  double square(double q_x, double q_z) const { return xx * q_x * q_x + 2.0 * xz * q_x * q_z + zz * q_z * q_z; }
};

/// Sums over pixels of weight 1/sigma_w^2. Moments of disjoint regions add exactly.
struct PlaneMoments {
  double n = 0.0;
  bool turning = false;                              ///< rays of a scan: their x and z are a unit vector
  Eigen::Matrix3d rays = Eigen::Matrix3d::Zero();    ///< sum of ray ray^T / sigma^2
  Eigen::Vector3d rays_w = Eigen::Vector3d::Zero();  ///< sum of ray w / sigma^2
  double w_w = 0.0;                                  ///< sum of w^2 / sigma^2
  double w_sum = 0.0;                                ///< sum of w (unweighted, for the mean)

  PlaneMoments& operator+=(const PlaneMoments& other) {
    n += other.n;
    turning = turning || other.turning;
    rays += other.rays;
    rays_w += other.rays_w;
    w_w += other.w_w;
    w_sum += other.w_sum;
    return *this;
  }
  void add(const Eigen::Vector3d& ray, double w, double variance) {
    const double weight = 1.0 / variance;
    n += 1.0;
    rays.noalias() += weight * ray * ray.transpose();
    rays_w += (weight * w) * ray;
    w_w += weight * w * w;
    w_sum += w;
  }
  double meanW() const { return n > 0.0 ? w_sum / n : 0.0; }

  AcrossDirection across() const {
    return turning ? AcrossDirection(rays(0, 0), rays(0, 2), rays(2, 2)) : AcrossDirection();
  }

  /// Least squares with a ridge on the two slopes, across and along, q = (M + ridge (e e^T + y y^T))^-1 b.
  PlaneEstimate fit(double ridge) const {
    const AcrossDirection e = across();
    Eigen::Matrix3d a = rays;
    a(0, 0) += ridge * e.xx;
    a(0, 2) += ridge * e.xz;
    a(2, 0) += ridge * e.xz;
    a(2, 2) += ridge * e.zz;
    a(1, 1) += ridge;
    PlaneEstimate estimate;
    estimate.inverse = a.inverse();
    estimate.q = estimate.inverse * rays_w;
    // No number where there is no q.
    estimate.rss = std::max(w_w - 2.0 * estimate.q.dot(rays_w) + estimate.q.dot(rays * estimate.q), 0.0);
    return estimate;
  }
};

/// 1 + tan^2 theta between the viewing ray and the normal: by how much an orthogonal error grows along the
/// ray, squared. tan^2 = ((q . e)^2 + q_y^2) / w^2, the slopes across and along, clipped at 25.
inline double slopeFactor(const Eigen::Vector3d& q, double mean_w, const AcrossDirection& e = AcrossDirection()) {
  const double tan2 = (e.square(q.x(), q.z()) + q.y() * q.y()) / std::max(mean_w * mean_w, 1e-12);
  return 1.0 + std::min(tan2, 25.0);
}

/// The plane of a region of many scan lines, as S4 to S8 use it. A weak ridge keeps regions of a single line solvable.
struct RegionPlane {
  Eigen::Vector3d q = Eigen::Vector3d::Zero();
  double rss = 0.0;           ///< weighted residual sum of squares, in units of sigma^2
  double slope_factor = 1.0;  ///< see slopeFactor()

  RegionPlane() = default;
  explicit RegionPlane(const PlaneMoments& region) {
    if (region.n <= 0.0) return;
    const double w = region.meanW();
    const PlaneEstimate fit = region.fit(0.25 / (w * w));
    q = fit.q;
    rss = fit.rss;
    slope_factor = slopeFactor(q, w, region.across());
  }
};

}  // namespace epcc
