// SPDX-License-Identifier: BSD-3-Clause
// Each label against its four neighbours, a vector at a time.
#include "label_margin.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "label_margin.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "vector/dispatch.h"

HWY_BEFORE_NAMESPACE();
namespace epcc {
namespace HWY_NAMESPACE {
namespace {

#if HWY_TARGET == HWY_EMU128  // the compiler makes vectors of a plain loop, but not of emulated masks

void keep(const std::int32_t* labels, const std::int32_t* above, const std::int32_t* below, std::size_t count,
          std::size_t margin, std::int32_t* HWY_RESTRICT inside) {
  const std::int32_t *before = labels - margin, *after = labels + margin;
  // All bits of another label.
  const auto other = [](std::int32_t label, std::int32_t here) { return -static_cast<std::int32_t>(label != here); };
  for (std::size_t i = 0; i < count; ++i) {
    const std::int32_t here = labels[i];
    inside[i] =
        here & ~(other(before[i], here) | other(after[i], here) | other(above[i], here) | other(below[i], here));
  }
}

#else

void keep(const std::int32_t* labels, const std::int32_t* above, const std::int32_t* below, std::size_t count,
          std::size_t margin, std::int32_t* HWY_RESTRICT inside) {
  namespace hn = hwy::HWY_NAMESPACE;
  const hn::CappedTag<std::int32_t, kBehindLabels> d;
  constexpr std::size_t kLanes = hn::MaxLanes(d);
  for (std::size_t i = 0; i < count; i += kLanes) {
    const auto here = hn::LoadU(d, labels + i);
    const auto other = [&](const std::int32_t* row) HWY_ATTR {
      const auto label = hn::LoadU(d, row + i);
      return hn::Not(hn::VecFromMask(d, hn::Eq(label, here)));
    };
    const auto near =
        hn::Or(hn::Or(other(labels - margin), other(labels + margin)), hn::Or(other(above), other(below)));
    hn::StoreU(hn::AndNot(near, here), d, inside + i);
  }
}

#endif

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace epcc
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace epcc {

namespace {
HWY_EXPORT(keep);
}

void keepInside(const std::int32_t* labels, const std::int32_t* above, const std::int32_t* below, std::size_t count,
                std::size_t margin, std::int32_t* inside) {
  EPCC_KERNEL(keep)(labels, above, below, count, margin, inside);
}

}  // namespace epcc
#endif
