// SPDX-License-Identifier: BSD-3-Clause
// Most vectors of labels hold one label alone.
#include "label_table.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "label_table.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "vector/dispatch.h"

HWY_BEFORE_NAMESPACE();
namespace epcc {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
namespace {

using Int = hn::ScalableTag<std::int32_t>;
constexpr std::size_t kLanes = hn::MaxLanes(Int());

bool countPart(const std::int32_t* labels, std::size_t size, std::int32_t label_count, long* pixels) {
  const Int d;
  bool stray = false;
  const auto add = [&](std::int32_t label, long times) {
    if (label >= 1 && label <= label_count)
      pixels[label - 1] += times;
    else
      stray = stray || label != 0;
  };
  std::size_t i = 0;
  for (; i + kLanes <= size; i += kLanes) {
    if (hn::AllTrue(d, hn::Eq(hn::LoadU(d, labels + i), hn::Set(d, labels[i]))))
      add(labels[i], static_cast<long>(kLanes));
    else
      for (std::size_t k = 0; k < kLanes; ++k) add(labels[i + k], 1);
  }
  for (; i < size; ++i) add(labels[i], 1);
  return stray;
}

void changePart(std::int32_t* labels, std::size_t size, std::int32_t label_count, const std::int32_t* new_label) {
  const Int d;
  const auto none = hn::Zero(d);
  const auto last = hn::Set(d, label_count);
  std::size_t i = 0;
  for (; i + kLanes <= size; i += kLanes) {
    const auto label = hn::LoadU(d, labels + i);
    if (hn::AllTrue(d, hn::Eq(label, none))) continue;
    const auto known = hn::IfThenElseZero(hn::AndNot(hn::Gt(label, last), hn::Gt(label, none)), label);
    hn::StoreU(hn::GatherIndex(d, new_label, known), d, labels + i);
  }
  for (; i < size; ++i) labels[i] = labels[i] > 0 && labels[i] <= label_count ? new_label[labels[i]] : 0;
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
