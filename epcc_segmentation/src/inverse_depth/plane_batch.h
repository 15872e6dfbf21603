// SPDX-License-Identifier: BSD-3-Clause
// The planes of up to sixteen regions at once: S4 judges contacts by thousands.
#pragma once

#include "inverse_depth/region_sums.h"

namespace epcc {

/// Sums of regions with pixels, each value side by side, and the planes that fit them.
struct PlaneBatch {
  static constexpr int kSize = 16;
  static constexpr int kSums = 12;

  int count = 0;
  bool turning = false;            ///< rays of a scan
  double sums[kSums][kSize] = {};  ///< in the order of RegionSums
  double x[kSize], y[kSize], z[kSize], rss[kSize], slope_factor[kSize];

  void add(const RegionSums& s) {
    const double values[kSums] = {s.n, s.w_sum, s.w_w, s.xw, s.yw, s.zw, s.xx, s.xy, s.xz, s.yy, s.yz, s.zz};
    for (int k = 0; k < kSums; ++k) sums[k][count] = values[k];
    turning = s.turning;
    ++count;
  }
  SumsPlane plane(int k) const {
    SumsPlane result;
    result.x = x[k];
    result.y = y[k];
    result.z = z[k];
    result.rss = rss[k];
    result.slope_factor = slope_factor[k];
    return result;
  }
};

/// Fits the planes, each to the bit that of SumsPlane.
void fitPlanes(PlaneBatch& batch);

}  // namespace epcc
