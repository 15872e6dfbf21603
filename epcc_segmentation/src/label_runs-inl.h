// SPDX-License-Identifier: BSD-3-Clause
// Runs of equal labels; part of kernels, compiled for each vector unit.
#if defined(EPCC_LABEL_RUNS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef EPCC_LABEL_RUNS_INL_H_
#undef EPCC_LABEL_RUNS_INL_H_
#else
#define EPCC_LABEL_RUNS_INL_H_
#endif

#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace epcc {
namespace HWY_NAMESPACE {
namespace {

constexpr std::size_t kRunBlock = 16;

/// Calls visit(begin, end) for each run of equal labels in turn. A run ends where the next label is another.
template <typename Visit>
HWY_INLINE void forEachRun(const std::int32_t* labels, std::size_t count, const Visit& visit) {
  std::size_t begin = 0, i = 0;
  const auto endRun = [&](std::size_t end) HWY_ATTR {
    visit(begin, end);
    begin = end;
  };
#if HWY_TARGET == HWY_EMU128  // without masks: most blocks have no end, and the compiler finds out in vectors
  for (; i + kRunBlock < count; i += kRunBlock) {
    std::int32_t differs = 0;
    for (std::size_t k = i; k < i + kRunBlock; ++k) differs |= labels[k] ^ labels[k + 1];
    if (differs == 0) continue;
    for (std::size_t k = i; k < i + kRunBlock; ++k)
      if (labels[k] != labels[k + 1]) endRun(k + 1);
  }
#else
  namespace hn = hwy::HWY_NAMESPACE;
  const hn::CappedTag<std::int32_t, kRunBlock> d;
  constexpr std::size_t kLanes = hn::MaxLanes(d);
  for (; i + kLanes < count; i += kLanes) {
    const auto ends = hn::Ne(hn::LoadU(d, labels + i), hn::LoadU(d, labels + i + 1));
    if (hn::AllFalse(d, ends)) continue;
    std::uint8_t bytes[8] = {};  // as many may be written
    hn::StoreMaskBits(d, ends, bytes);
    for (unsigned bits = bytes[0] | static_cast<unsigned>(bytes[1]) << 8; bits != 0; bits &= bits - 1)
      endRun(i + static_cast<std::size_t>(__builtin_ctz(bits)) + 1);
  }
#endif
  for (; i < count; ++i)
    if (i + 1 == count || labels[i] != labels[i + 1]) endRun(i + 1);
}

/// True if all labels of a block of kRunBlock are this one.
HWY_INLINE bool isWholeBlock(const std::int32_t* labels, std::int32_t label) {
#if HWY_TARGET == HWY_EMU128
  std::int32_t differs = 0;
  for (std::size_t k = 0; k < kRunBlock; ++k) differs |= labels[k] ^ label;
  return differs == 0;
#else
  namespace hn = hwy::HWY_NAMESPACE;
  const hn::CappedTag<std::int32_t, kRunBlock> d;
  auto differs = hn::Zero(d);
  for (std::size_t k = 0; k < kRunBlock; k += hn::MaxLanes(d))
    differs = hn::Or(differs, hn::Xor(hn::LoadU(d, labels + k), hn::Set(d, label)));
  return hn::AllTrue(d, hn::Eq(differs, hn::Zero(d)));
#endif
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace epcc
HWY_AFTER_NAMESPACE();

#endif
