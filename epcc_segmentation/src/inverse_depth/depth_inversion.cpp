// SPDX-License-Identifier: BSD-3-Clause
// Inverse depths and weights by arithmetic: tables of the depths of a sensor are slower.
#include "inverse_depth/depth_inversion.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "inverse_depth/depth_inversion.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <limits>

#include "inverse_depth/noise_variance-inl.h"
#include "vector/dispatch.h"
#include "vector/extremes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace epcc {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

#if HWY_TARGET == HWY_EMU128  // the compiler makes vectors of plain loops, but not of emulated masks

constexpr float kLargest = std::numeric_limits<float>::max();

/// w = 1/z; that of infinity is 0.
void InvertDepths(const float* depth, std::size_t count, float* w) {
  for (std::size_t i = 0; i < count; ++i) {
    const bool may_be = (depth[i] > 0.0f) & (depth[i] <= kFarthestMeasured);
    const float inverse = 1.0f / (may_be ? depth[i] : std::numeric_limits<float>::infinity());
    w[i] = inverse <= kLargestInverse ? inverse : 0.0f;
  }
}

/// sigma_w^2 as below.
void WeighInverseDepths(const float* w, std::size_t count, const InverseDepthNoise* noise, float scale, float* weight) {
  const auto k1 = static_cast<float>(noise->k1), k2 = static_cast<float>(noise->k2), k3 = static_cast<float>(noise->k3);
  const auto a2 = static_cast<float>(noise->a2), b2 = static_cast<float>(noise->b2);
  const auto place2 = static_cast<float>(noise->place2);
  const float scale2 = scale * scale;
  for (std::size_t i = 0; i < count; ++i) {
    const float m = w[i] * scale;
    const float m2 = m * m;
    const float polynomial = k1 + m * (k2 + m * k3);
    const float variance = larger(polynomial * polynomial + (b2 + (a2 * m2) * m2), place2 * m2);
    weight[i] = smaller(kLargest, larger(scale2 / variance, std::numeric_limits<float>::min()));  // least if NaN
  }
}

#else

using Floats = hn::ScalableTag<float>;
using FloatVector = hn::Vec<Floats>;

/// Calls step(vector) -> vector for all values; the last ones go through a vector of their own.
template <typename Step>
HWY_INLINE void forEachVector(const float* from, std::size_t count, float* to, const Step& step) {
  const Floats d;
  constexpr std::size_t kLanes = hn::MaxLanes(d);
  std::size_t i = 0;
  for (; i + kLanes <= count; i += kLanes) hn::StoreU(step(hn::LoadU(d, from + i)), d, to + i);
  if (i == count) return;
  alignas(64) float rest[kLanes] = {};
  for (std::size_t k = 0; i + k < count; ++k) rest[k] = from[i + k];
  hn::Store(step(hn::Load(d, rest)), d, rest);
  for (std::size_t k = 0; i + k < count; ++k) to[i + k] = rest[k];
}

/// w = 1/z.
void InvertDepths(const float* depth, std::size_t count, float* w) {
  const Floats d;
  const auto one = hn::Set(d, 1.0f);
  const auto zero = hn::Zero(d);
  const auto farthest = hn::Set(d, kFarthestMeasured);
  const auto largest = hn::Set(d, kLargestInverse);
  forEachVector(depth, count, w, [&](FloatVector z) HWY_ATTR {
    const auto valid = hn::And(hn::Gt(z, zero), hn::Le(z, farthest));
    const auto inverse = hn::Div(one, hn::IfThenElse(valid, z, one));
    return hn::IfThenElseZero(hn::And(valid, hn::Le(inverse, largest)), inverse);
  });
}

/// 1/sigma_w^2 at the measured inverse depth.
void WeighInverseDepths(const float* w, std::size_t count, const InverseDepthNoise* noise, float scale, float* weight) {
  const Floats d;
  const NoiseVectors<Floats> noise_vectors(d, *noise);
  const auto scales = hn::Set(d, scale);
  const auto scale2 = hn::Set(d, scale * scale);
  // A float holds the weight of any depth that a sensor gives; of others, whose variance may be no number, it stays
  // finite and positive.
  const auto least = hn::Set(d, std::numeric_limits<float>::min());
  const auto most = hn::Set(d, std::numeric_limits<float>::max());
  forEachVector(w, count, weight, [&](FloatVector value) HWY_ATTR {
    const auto variance = noise_vectors.variance(hn::Mul(value, scales));
    const auto one = hn::Div(scale2, variance);
    return hn::IfThenElse(hn::Gt(one, least), smaller(most, one), least);
  });
}

#endif

}  // namespace HWY_NAMESPACE
}  // namespace epcc
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace epcc {

HWY_EXPORT(InvertDepths);
HWY_EXPORT(WeighInverseDepths);

void invertDepths(const float* depth, std::size_t count, float* w) {
  EPCC_KERNEL(InvertDepths)(depth, count, w);
}

void weighInverseDepths(const float* w, std::size_t count, const InverseDepthNoise& noise, float scale, float* weight) {
  EPCC_KERNEL(WeighInverseDepths)(w, count, &noise, scale, weight);
}

}  // namespace epcc
#endif
