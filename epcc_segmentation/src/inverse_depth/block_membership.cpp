// SPDX-License-Identifier: BSD-3-Clause
// Run by run of equal sample labels: a plane's numbers are loaded once a run.
#include "inverse_depth/block_membership.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "inverse_depth/block_membership.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "inverse_depth/noise_variance-inl.h"
#include "vector/dispatch.h"

HWY_BEFORE_NAMESPACE();
namespace epcc {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::ScalableTag<float>;
using Labels = hn::Rebind<std::int32_t, Floats>;
constexpr int kLanes = static_cast<int>(hn::MaxLanes(Floats()));

/// The pixels [begin, end) of one label; a whole vector may be written beyond the end, but not beyond the row.
template <bool kPolynomial>
HWY_INLINE void LabelRun(const PixelRow& row, std::int32_t label, int begin, int end, std::int32_t* labels) {
  const Floats d;
  const Labels di;
  const NoiseVectors<Floats> noise(d, *row.noise);
  const PixelPlane& plane = row.planes[label];
  const auto scale = hn::Set(d, row.scale);
  const auto q_across = hn::Set(d, plane.across);
  const auto q_forward = hn::Set(d, plane.forward);
  const auto along = hn::Set(d, plane.along * row.along);
  const auto limit = hn::Set(d, row.max_residual2 * plane.slope);
  const auto own = hn::Set(di, label);
  const auto members = [&](const float* w_at, const float* across_at, const float* forward_at) HWY_ATTR {
    const auto w = hn::LoadU(d, w_at);
    const auto expected = hn::Add(hn::Add(hn::Mul(q_across, hn::LoadU(d, across_at)), along),
                                  hn::Mul(q_forward, hn::LoadU(d, forward_at)));
    const auto variance = noise.template variance<kPolynomial>(hn::Mul(w, scale));
    const auto residual = hn::Mul(hn::Sub(w, expected), scale);
    const auto on_plane = hn::Le(hn::Mul(residual, residual), hn::Mul(limit, variance));
    return hn::IfThenElseZero(hn::RebindMask(di, hn::And(on_plane, hn::Gt(w, hn::Zero(d)))), own);
  };
  int i = begin;
  for (; i < end && i + kLanes <= row.width; i += kLanes)
    hn::StoreU(members(row.w + i, row.across + i, row.forward + i), di, labels + i);
  if (i >= end) return;
  alignas(64) float w[kLanes] = {}, across[kLanes] = {}, forward[kLanes] = {};
  alignas(64) std::int32_t rest[kLanes];
  for (int k = 0; i + k < end; ++k) {
    w[k] = row.w[i + k];
    across[k] = row.across[i + k];
    forward[k] = row.forward[i + k];
  }
  hn::Store(members(w, across, forward), di, rest);
  for (int k = 0; i + k < end; ++k) labels[i + k] = rest[k];
}

/// Pixels of no label need no test.
HWY_INLINE void ClearRun(int begin, int end, std::int32_t* labels) {
  for (int i = begin; i < end; ++i) labels[i] = 0;
}

template <bool kPolynomial>
HWY_INLINE void LabelRow(const PixelRow& row, std::int32_t* labels) {
  for (int begin = 0, end = 0; begin < row.samples; begin = end) {
    const std::int32_t label = row.sample_labels[begin];
    while (end < row.samples && row.sample_labels[end] == label) ++end;
    const int pixel_begin = begin * row.stride;
    const int pixel_end = end < row.samples ? end * row.stride : row.width;
    if (label == 0)
      ClearRun(pixel_begin, pixel_end, labels);
    else
      LabelRun<kPolynomial>(row, label, pixel_begin, pixel_end, labels);
  }
}

void LabelMembers(const PixelRow* row, std::int32_t* labels) {
  const InverseDepthNoise& noise = *row->noise;
  if (noise.k1 == 0.0 && noise.k2 == 0.0 && noise.k3 == 0.0)
    LabelRow<false>(*row, labels);
  else
    LabelRow<true>(*row, labels);
}

}  // namespace HWY_NAMESPACE
}  // namespace epcc
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace epcc {

HWY_EXPORT(LabelMembers);

void labelMembers(const PixelRow& row, std::int32_t* labels) {
  EPCC_KERNEL(LabelMembers)(&row, labels);
}

}  // namespace epcc
#endif
