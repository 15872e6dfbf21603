// SPDX-License-Identifier: BSD-3-Clause
// Whether a block of labels is one label; part of kernels, compiled for each vector unit.
#if defined(EPCC_UNIFORM_BLOCK_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef EPCC_UNIFORM_BLOCK_INL_H_
#undef EPCC_UNIFORM_BLOCK_INL_H_
#else
#define EPCC_UNIFORM_BLOCK_INL_H_
#endif

#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace epcc {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// All of a block are the first.
template <std::size_t kLabels>
HWY_INLINE bool isUniform(const std::int32_t* labels) {
#if HWY_TARGET == HWY_EMU128
  const hn::CappedTag<std::int32_t, kLabels> d;
  const auto first = hn::Set(d, labels[0]);
  auto differs = hn::Zero(d);
  for (std::size_t i = 0; i < kLabels; i += hn::MaxLanes(d))
    differs = hn::Or(differs, hn::Xor(hn::LoadU(d, labels + i), first));
  std::int32_t parts[hn::MaxLanes(d)];
  hn::StoreU(differs, d, parts);
  std::int32_t any = 0;
  for (const std::int32_t part : parts) any |= part;
  return any == 0;
#else
  const hn::CappedTag<std::int32_t, kLabels> d;
  const auto first = hn::Set(d, labels[0]);
  auto same = hn::Eq(hn::LoadU(d, labels), first);
  for (std::size_t i = hn::MaxLanes(d); i < kLabels; i += hn::MaxLanes(d))
    same = hn::And(same, hn::Eq(hn::LoadU(d, labels + i), first));
  return hn::AllTrue(d, same);
#endif
}

}  // namespace HWY_NAMESPACE
}  // namespace epcc
HWY_AFTER_NAMESPACE();

#endif
