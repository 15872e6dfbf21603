// SPDX-License-Identifier: BSD-3-Clause
// Most blocks of pixels have one label: it is looked up once, and nothing is written if it stays.
#include "inverse_depth/relabelling.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "inverse_depth/relabelling.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>

#include "inverse_depth/relabelling.h"
#include "inverse_depth/uniform_block-inl.h"
#include "vector/dispatch.h"

HWY_BEFORE_NAMESPACE();
namespace epcc {
namespace HWY_NAMESPACE {

constexpr std::size_t kBlock = kRelabelledBlock;

/// labels[i] = new_label[labels[i]].
void relabel(std::int32_t* labels, std::size_t count, const std::int32_t* new_label) {
  std::size_t i = 0;
  for (; i + kBlock <= count; i += kBlock) {
    std::int32_t* block = labels + i;
    if (isUniform<kBlock>(block)) {
      const std::int32_t label = new_label[block[0]];
      if (label != block[0])
        for (std::size_t k = 0; k < kBlock; ++k) block[k] = label;
    } else {
      for (std::size_t k = 0; k < kBlock; ++k) block[k] = new_label[block[k]];
    }
  }
  for (; i < count; ++i) labels[i] = new_label[labels[i]];
}

/// to[i] = new_label[labels[i]].
void relabelInto(const std::int32_t* labels, std::size_t count, const std::int32_t* new_label, std::int32_t* to) {
  std::size_t i = 0;
  for (; i + kBlock <= count; i += kBlock) {
    if (isUniform<kBlock>(labels + i))
      std::fill_n(to + i, kBlock, new_label[labels[i]]);
    else
      for (std::size_t k = i; k < i + kBlock; ++k) to[k] = new_label[labels[k]];
  }
  for (; i < count; ++i) to[i] = new_label[labels[i]];
}

}  // namespace HWY_NAMESPACE
}  // namespace epcc
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace epcc {

HWY_EXPORT(relabel);
HWY_EXPORT(relabelInto);

void relabelPixels(std::int32_t* labels, std::size_t count, const std::int32_t* new_label) {
  EPCC_KERNEL(relabel)(labels, count, new_label);
}

void relabelPixels(const std::int32_t* labels, std::size_t count, const std::int32_t* new_label, std::int32_t* to) {
  EPCC_KERNEL(relabelInto)(labels, count, new_label, to);
}

}  // namespace epcc
#endif  // HWY_ONCE
