// SPDX-License-Identifier: BSD-3-Clause
// Labels lie in runs: they are counted run by run, and most vectors of them hold one label alone.
#include "label_table.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "label_table.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "label_runs-inl.h"
#include "vector/dispatch.h"

HWY_BEFORE_NAMESPACE();
namespace epcc {
namespace HWY_NAMESPACE {
namespace {

bool countPart(const std::int32_t* labels, std::size_t size, std::int32_t label_count, long* pixels) {
  bool stray = false;
  forEachRun(labels, size, [&](std::size_t begin, std::size_t end) HWY_ATTR {
    const std::int32_t label = labels[begin];
    if (label >= 1 && label <= label_count)
      pixels[label - 1] += static_cast<long>(end - begin);
    else
      stray = stray || label != 0;
  });
  return stray;
}

HWY_INLINE std::int32_t changed(std::int32_t label, std::int32_t label_count, const std::int32_t* new_label) {
  return label > 0 && label <= label_count ? new_label[label] : 0;
}

/// Blocks of one label that keeps its number are left alone.
void changePart(std::int32_t* labels, std::size_t size, std::int32_t label_count, const std::int32_t* new_label) {
  std::int32_t label = 0, now = 0;  // that a block begins with
  std::size_t i = 0;
  for (; i + kRunBlock <= size; i += kRunBlock) {
    if (labels[i] != label) {
      label = labels[i];
      now = changed(label, label_count, new_label);
    }
    if (!isWholeBlock(labels + i, label))
      for (std::size_t k = i; k < i + kRunBlock; ++k) labels[k] = changed(labels[k], label_count, new_label);
    else if (now != label)
      for (std::size_t k = i; k < i + kRunBlock; ++k) labels[k] = now;
  }
  for (; i < size; ++i) labels[i] = changed(labels[i], label_count, new_label);
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace epcc
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace epcc {

namespace {
HWY_EXPORT(countPart);
HWY_EXPORT(changePart);
}  // namespace

bool countLabels(const std::int32_t* labels, std::size_t count, std::int32_t label_count, long* pixels) {
  return EPCC_KERNEL(countPart)(labels, count, label_count, pixels);
}

void changeLabels(std::int32_t* labels, std::size_t count, std::int32_t label_count, const std::int32_t* new_label) {
  EPCC_KERNEL(changePart)(labels, count, label_count, new_label);
}

}  // namespace epcc
#endif
