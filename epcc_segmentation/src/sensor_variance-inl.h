// SPDX-License-Identifier: BSD-3-Clause
// sigma_z^2 (Eq. 22) of a vector of depths; part of kernels, compiled for each vector unit.
#if defined(EPCC_SENSOR_VARIANCE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef EPCC_SENSOR_VARIANCE_INL_H_
#undef EPCC_SENSOR_VARIANCE_INL_H_
#else
#define EPCC_SENSOR_VARIANCE_INL_H_
#endif

#include <hwy/highway.h>

#include "sensor_variance.h"
#include "vector/extremes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace epcc {
namespace HWY_NAMESPACE {
namespace {

template <class D>
HWY_INLINE hwy::HWY_NAMESPACE::Vec<D> varianceOf(D d, const SensorVariance& v, hwy::HWY_NAMESPACE::Vec<D> z) {
  namespace hn = hwy::HWY_NAMESPACE;
  const auto polynomial =
      hn::Add(hn::Mul(hn::Add(hn::Mul(hn::Set(d, v.k0), z), hn::Set(d, v.k1)), z), hn::Set(d, v.k2));
  const auto spread = larger(polynomial, hn::Zero(d));
  const auto variance = hn::Add(hn::Mul(spread, spread), hn::Set(d, v.floor));
  return smaller(larger(variance, hn::Set(d, v.smallest)), hn::Set(d, v.largest));
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace epcc
HWY_AFTER_NAMESPACE();

#endif
