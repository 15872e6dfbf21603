// SPDX-License-Identifier: BSD-3-Clause
// Most blocks of pixels have one label: it is looked up once, and nothing is written if it stays.
#include "inverse_depth/relabelling.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "inverse_depth/relabelling.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "inverse_depth/relabelling.h"
#include "vector/dispatch.h"

HWY_BEFORE_NAMESPACE();
namespace epcc {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

constexpr std::size_t kBlock = kRelabelledBlock;

/// All of a block are the first.
HWY_INLINE bool isUniform(const std::int32_t* labels) {
#if HWY_TARGET == HWY_EMU128
  const hn::CappedTag<std::int32_t, kBlock> d;
  const auto first = hn::Set(d, labels[0]);
  auto differs = hn::Zero(d);
  for (std::size_t i = 0; i < kBlock; i += hn::MaxLanes(d))
    differs = hn::Or(differs, hn::Xor(hn::LoadU(d, labels + i), first));
  std::int32_t parts[hn::MaxLanes(d)];
  hn::StoreU(differs, d, parts);
  std::int32_t any = 0;
  for (const std::int32_t part : parts) any |= part;
  return any == 0;
#else
  const hn::CappedTag<std::int32_t, kBlock> d;
  const auto first = hn::Set(d, labels[0]);
  auto same = hn::Eq(hn::LoadU(d, labels), first);
  for (std::size_t i = hn::MaxLanes(d); i < kBlock; i += hn::MaxLanes(d))
    same = hn::And(same, hn::Eq(hn::LoadU(d, labels + i), first));
  return hn::AllTrue(d, same);
#endif
}

/// labels[i] = new_label[labels[i]].
void relabel(std::int32_t* labels, std::size_t count, const std::int32_t* new_label) {
  std::size_t i = 0;
  for (; i + kBlock <= count; i += kBlock) {
    std::int32_t* block = labels + i;
    if (isUniform(block)) {
      const std::int32_t label = new_label[block[0]];
      if (label != block[0])
        for (std::size_t k = 0; k < kBlock; ++k) block[k] = label;
    } else {
      for (std::size_t k = 0; k < kBlock; ++k) block[k] = new_label[block[k]];
    }
  }
  for (; i < count; ++i) labels[i] = new_label[labels[i]];
}

}  // namespace HWY_NAMESPACE
}  // namespace epcc
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace epcc {

HWY_EXPORT(relabel);

void relabelPixels(std::int32_t* labels, std::size_t count, const std::int32_t* new_label) {
  EPCC_KERNEL(relabel)(labels, count, new_label);
}

}  // namespace epcc
#endif  // HWY_ONCE
