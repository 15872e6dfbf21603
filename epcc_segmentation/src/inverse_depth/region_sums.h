// SPDX-License-Identifier: BSD-3-Clause
// The moments of a region with their symmetric part once, and its plane in closed form: S4 asks for thousands of them.
#pragma once

#include <Eigen/Core>
#include <algorithm>

#include "inverse_depth/plane_moments.h"

namespace epcc {

/// PlaneMoments with the upper triangle of rays alone.
struct RegionSums {
  double n = 0.0, w_sum = 0.0, w_w = 0.0;
  double xw = 0.0, yw = 0.0, zw = 0.0;
  double xx = 0.0, xy = 0.0, xz = 0.0, yy = 0.0, yz = 0.0, zz = 0.0;
  bool turning = false;

  RegionSums() = default;
  explicit RegionSums(const PlaneMoments& moments);
  RegionSums operator+(const RegionSums& other) const;
};

/// RegionPlane from the sums: q from the adjugate of the normal matrix, no inverse.
struct SumsPlane {
  double x = 0.0, y = 0.0, z = 0.0;  ///< q
  double rss = 0.0;                  ///< weighted residual sum of squares, in units of sigma^2
  double slope_factor = 1.0;         ///< see slopeFactor()

  SumsPlane() = default;
  explicit SumsPlane(const RegionSums& sums);
};

inline RegionSums::RegionSums(const PlaneMoments& m)
    : n(m.n),
      w_sum(m.w_sum),
      w_w(m.w_w),
      xw(m.rays_w.x()),
      yw(m.rays_w.y()),
      zw(m.rays_w.z()),
      xx(m.rays(0, 0)),
      xy(m.rays(0, 1)),
      xz(m.rays(0, 2)),
      yy(m.rays(1, 1)),
      yz(m.rays(1, 2)),
      zz(m.rays(2, 2)),
      turning(m.turning) {}

inline RegionSums RegionSums::operator+(const RegionSums& other) const {
  RegionSums sum = *this;
  sum.n += other.n;
  sum.turning = sum.turning || other.turning;
  sum.w_sum += other.w_sum;
  sum.w_w += other.w_w;
  sum.xw += other.xw;
  sum.yw += other.yw;
  sum.zw += other.zw;
  sum.xx += other.xx;
  sum.xy += other.xy;
  sum.xz += other.xz;
  sum.yy += other.yy;
  sum.yz += other.yz;
  sum.zz += other.zz;
  return sum;
}

inline SumsPlane::SumsPlane(const RegionSums& s) {
  if (s.n <= 0.0) return;
  const double w = s.w_sum / s.n;
  const double ridge = 0.25 / (w * w);
  const AcrossDirection e = s.turning ? AcrossDirection(s.xx, s.xz, s.zz) : AcrossDirection();
  const double a = s.xx + ridge * e.xx, b = s.yy + ridge, c = s.zz + ridge * e.zz, d = s.xz + ridge * e.xz;
  const double xx = b * c - s.yz * s.yz, xy = d * s.yz - s.xy * c, xz = s.xy * s.yz - d * b;
  const double yy = a * c - d * d, yz = s.xy * d - a * s.yz, zz = a * b - s.xy * s.xy;
  const double scale = 1.0 / (a * xx + s.xy * xy + d * xz);
  x = scale * (xx * s.xw + xy * s.yw + xz * s.zw);
  y = scale * (xy * s.xw + yy * s.yw + yz * s.zw);
  z = scale * (xz * s.xw + yz * s.yw + zz * s.zw);
  // Of second order in the error of q, unlike w_w - q . rays_w; no number where there is no q, which nothing merges
  // with.
  const double square = x * (s.xx * x + s.xy * y + s.xz * z) + y * (s.xy * x + s.yy * y + s.yz * z) +
                        z * (s.xz * x + s.yz * y + s.zz * z);
  rss = std::max(s.w_w - 2.0 * (x * s.xw + y * s.yw + z * s.zw) + square, 0.0);
  slope_factor = slopeFactor({x, y, z}, w, e);
}

}  // namespace epcc
