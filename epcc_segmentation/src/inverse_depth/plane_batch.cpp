// SPDX-License-Identifier: BSD-3-Clause
// SumsPlane in lanes, one region in each.
#include "inverse_depth/plane_batch.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "inverse_depth/plane_batch.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "vector/dispatch.h"
#include "vector/extremes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace epcc {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Doubles = hn::CappedTag<double, PlaneBatch::kSize>;
using Double = hn::Vec<Doubles>;
constexpr int kLanes = static_cast<int>(hn::MaxLanes(Doubles()));

/// a b - c d
HWY_INLINE Double minor(Double a, Double b, Double c, Double d) {
  return hn::Sub(hn::Mul(a, b), hn::Mul(c, d));
}

/// a x + b y + c z
HWY_INLINE Double dot(Double a, Double x, Double b, Double y, Double c, Double z) {
  return hn::Add(hn::Add(hn::Mul(a, x), hn::Mul(b, y)), hn::Mul(c, z));
}

/// AcrossDirection
struct Across {
  HWY_INLINE Across(bool turning, Double sum_xx, Double sum_xz, Double sum_zz) {
    const Doubles d;
    const Double scale = hn::Div(hn::Set(d, turning ? 1.0 : 0.0), hn::Add(sum_xx, sum_zz));
    xx = turning ? hn::Mul(sum_zz, scale) : hn::Set(d, 1.0);
    xz = hn::Neg(hn::Mul(sum_xz, scale));
    zz = hn::Mul(sum_xx, scale);
  }
  HWY_INLINE Double square(Double x, Double z) const {
    const Double mixed = hn::Mul(hn::Mul(hn::Mul(hn::Set(Doubles(), 2.0), xz), x), z);
    return hn::Add(hn::Add(hn::Mul(hn::Mul(xx, x), x), mixed), hn::Mul(hn::Mul(zz, z), z));
  }

  Double xx, xz, zz;
};

// q = (M + ridge (e e^T + y y^T))^-1 b by the adjugate, RSS = w_w - 2 q b + q M q.
void fitPlaneLanes(PlaneBatch& batch) {
  const Doubles d;
  for (int k = 0; k < batch.count; k += kLanes) {
    const auto value = [&](int i) HWY_ATTR { return hn::LoadU(d, batch.sums[i] + k); };
    const Double w = hn::Div(value(1), value(0));
    const Double w_w = value(2), xw = value(3), yw = value(4), zw = value(5);
    const Double sxx = value(6), sxy = value(7), sxz = value(8), syy = value(9), syz = value(10), szz = value(11);
    const Double ridge = hn::Div(hn::Set(d, 0.25), hn::Mul(w, w));
    const Across e(batch.turning, sxx, sxz, szz);
    const Double a = hn::Add(sxx, hn::Mul(ridge, e.xx)), b = hn::Add(syy, ridge);
    const Double c = hn::Add(szz, hn::Mul(ridge, e.zz)), m = hn::Add(sxz, hn::Mul(ridge, e.xz));
    const Double xx = minor(b, c, syz, syz), xy = minor(m, syz, sxy, c), xz = minor(sxy, syz, m, b);
    const Double yy = minor(a, c, m, m), yz = minor(sxy, m, a, syz), zz = minor(a, b, sxy, sxy);
    const Double scale = hn::Div(hn::Set(d, 1.0), dot(a, xx, sxy, xy, m, xz));
    const Double x = hn::Mul(scale, dot(xx, xw, xy, yw, xz, zw));
    const Double y = hn::Mul(scale, dot(xy, xw, yy, yw, yz, zw));
    const Double z = hn::Mul(scale, dot(xz, xw, yz, yw, zz, zw));
    const Double square =
        dot(x, dot(sxx, x, sxy, y, sxz, z), y, dot(sxy, x, syy, y, syz, z), z, dot(sxz, x, syz, y, szz, z));
    const Double along = hn::Mul(hn::Set(d, 2.0), dot(x, xw, y, yw, z, zw));
    const Double rss = larger(hn::Zero(d), hn::Add(hn::Sub(w_w, along), square));
    const Double tan2 = hn::Div(hn::Add(e.square(x, z), hn::Mul(y, y)), larger(hn::Set(d, 1e-12), hn::Mul(w, w)));
    const Double slope_factor = hn::Add(hn::Set(d, 1.0), smaller(hn::Set(d, 25.0), tan2));
    hn::StoreU(x, d, batch.x + k);
    hn::StoreU(y, d, batch.y + k);
    hn::StoreU(z, d, batch.z + k);
    hn::StoreU(rss, d, batch.rss + k);
    hn::StoreU(slope_factor, d, batch.slope_factor + k);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace epcc
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace epcc {

HWY_EXPORT(fitPlaneLanes);

void fitPlanes(PlaneBatch& batch) {
  EPCC_KERNEL(fitPlaneLanes)(batch);
}

}  // namespace epcc
#endif  // HWY_ONCE
