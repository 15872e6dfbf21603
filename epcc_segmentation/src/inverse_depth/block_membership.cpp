// SPDX-License-Identifier: BSD-3-Clause
// Run by run of blocks of one label: a plane's numbers are loaded once a run.
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

/// The pixels [begin, end) of one label; 0 may be written beyond the end, but not beyond the row. Returns how many are
/// members.
template <bool kPolynomial, bool kPerspective>
HWY_INLINE long LabelRun(const PixelRow& row, std::int32_t label, int begin, int end, std::int32_t* labels) {
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
  auto count = hn::Zero(di);
  const auto members = [&](const float* w_at, const float* across_at, const float* forward_at, int pixels) HWY_ATTR {
    const auto w = hn::LoadU(d, w_at);
    const auto sum = hn::Add(hn::Mul(q_across, hn::LoadU(d, across_at)), along);
    const auto expected = hn::Add(sum, kPerspective ? q_forward : hn::Mul(q_forward, hn::LoadU(d, forward_at)));
    const auto variance = noise.template variance<kPolynomial>(kPerspective ? w : hn::Mul(w, scale));
    const auto error = hn::Sub(w, expected);
    const auto residual = kPerspective ? error : hn::Mul(error, scale);
    const auto on_plane = hn::Le(hn::Mul(residual, residual), hn::Mul(limit, variance));
    auto member = hn::RebindMask(di, hn::And(on_plane, hn::Gt(w, hn::Zero(d))));
    if (pixels < kLanes) member = hn::And(member, hn::Lt(hn::Iota(di, 0), hn::Set(di, pixels)));
    count = hn::Add(count, hn::IfThenElseZero(member, hn::Set(di, 1)));
    return hn::IfThenElseZero(member, own);
  };
  int i = begin;
  for (; i + kLanes <= end; i += kLanes)
    hn::StoreU(members(row.w + i, row.across + i, row.forward + i, kLanes), di, labels + i);
  if (i < end && i + kLanes <= row.width) {
    hn::StoreU(members(row.w + i, row.across + i, row.forward + i, end - i), di, labels + i);
  } else if (i < end) {
    alignas(64) float w[kLanes] = {}, across[kLanes] = {}, forward[kLanes] = {};
    alignas(64) std::int32_t rest[kLanes];
    for (int k = 0; i + k < end; ++k) {
      w[k] = row.w[i + k];
      across[k] = row.across[i + k];
      forward[k] = row.forward[i + k];
    }
    hn::Store(members(w, across, forward, end - i), di, rest);
    for (int k = 0; i + k < end; ++k) labels[i + k] = rest[k];
  }
  return hn::GetLane(hn::SumOfLanes(di, count));
}

/// Pixels of no label need no test.
HWY_INLINE void ClearRun(int begin, int end, std::int32_t* labels) {
  for (int i = begin; i < end; ++i) labels[i] = 0;
}

template <bool kPolynomial, bool kPerspective>
HWY_INLINE void LabelRow(const PixelRow& row, std::int32_t* labels, long* pixels) {
  for (int k = 0; k < row.runs.count; ++k) {
    const std::int32_t label = row.runs.labels[k];
    const int begin = row.runs.begins[k], end = row.runs.begins[k + 1];
    if (label == 0)
      ClearRun(begin, end, labels);
    else
      pixels[label] += LabelRun<kPolynomial, kPerspective>(row, label, begin, end, labels);
  }
}

void LabelMembers(const PixelRow* row, std::int32_t* labels, long* pixels) {
  const InverseDepthNoise& noise = *row->noise;
  const bool polynomial = noise.k1 != 0.0 || noise.k2 != 0.0 || noise.k3 != 0.0;
  if (!row->perspective)
    LabelRow<true, false>(*row, labels, pixels);
  else if (polynomial)
    LabelRow<true, true>(*row, labels, pixels);
  else
    LabelRow<false, true>(*row, labels, pixels);
}

}  // namespace HWY_NAMESPACE
}  // namespace epcc
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace epcc {

HWY_EXPORT(LabelMembers);

void labelMembers(const PixelRow& row, std::int32_t* labels, long* pixels) {
  EPCC_KERNEL(LabelMembers)(&row, labels, pixels);
}

}  // namespace epcc
#endif
