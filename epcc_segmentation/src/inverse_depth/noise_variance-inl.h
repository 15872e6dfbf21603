// SPDX-License-Identifier: BSD-3-Clause
// sigma_w^2 of a vector of inverse depths; part of kernels, compiled for each vector unit.
#if defined(EPCC_NOISE_VARIANCE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef EPCC_NOISE_VARIANCE_INL_H_
#undef EPCC_NOISE_VARIANCE_INL_H_
#else
#define EPCC_NOISE_VARIANCE_INL_H_
#endif

#include <hwy/highway.h>

#include "inverse_depth/inverse_depth_image.h"
#include "vector/extremes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace epcc {
namespace HWY_NAMESPACE {
namespace {

/// InverseDepthNoise::variance() in single precision, its numbers in vectors.
template <class D>
struct NoiseVectors {
  using V = hwy::HWY_NAMESPACE::Vec<D>;
  V k1, k2, k3, a2, b2, place2;

  HWY_INLINE NoiseVectors(D d, const InverseDepthNoise& noise)
      : k1(hwy::HWY_NAMESPACE::Set(d, static_cast<float>(noise.k1))),
        k2(hwy::HWY_NAMESPACE::Set(d, static_cast<float>(noise.k2))),
        k3(hwy::HWY_NAMESPACE::Set(d, static_cast<float>(noise.k3))),
        a2(hwy::HWY_NAMESPACE::Set(d, static_cast<float>(noise.a2))),
        b2(hwy::HWY_NAMESPACE::Set(d, static_cast<float>(noise.b2))),
        place2(hwy::HWY_NAMESPACE::Set(d, static_cast<float>(noise.place2))) {}

  /// max((k1 + k2 m + k3 m^2)^2 + b^2 + a^2 m^4, place^2 m^2) at the measured inverse depth m. Without kPolynomial the
  /// three k are 0.
  template <bool kPolynomial = true>
  HWY_INLINE V variance(V m) const {
    namespace hn = hwy::HWY_NAMESPACE;
    const auto m2 = hn::Mul(m, m);
    auto sum = hn::Add(b2, hn::Mul(hn::Mul(a2, m2), m2));
    if (kPolynomial) {
      const auto polynomial = hn::Add(k1, hn::Mul(m, hn::Add(k2, hn::Mul(m, k3))));
      sum = hn::Add(hn::Mul(polynomial, polynomial), sum);
    }
    return larger(sum, hn::Mul(place2, m2));
  }
};

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace epcc
HWY_AFTER_NAMESPACE();

#endif
