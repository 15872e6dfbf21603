// SPDX-License-Identifier: BSD-3-Clause
// A table look-up a pixel, of transposed views in blocks that stay in the cache.
#include "metric/pixel_labels.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "metric/pixel_labels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "parallel_for.h"
#include "vector/dispatch.h"

HWY_BEFORE_NAMESPACE();
namespace epcc {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
namespace {

void lookUp(const std::int32_t* numbers, std::size_t count, const std::int32_t* label_of, std::int32_t* labels) {
  const hn::CappedTag<std::int32_t, 16> d;
  const std::size_t lanes = hn::Lanes(d);
  std::size_t i = 0;
  for (; i + lanes <= count; i += lanes) {
    const auto number = hn::LoadU(d, numbers + i);
    // Most vectors lie in one segment's neighbours of one plane or in none at all.
    if (hn::AllTrue(d, hn::Eq(number, hn::Zero(d))))
      hn::StoreU(number, d, labels + i);
    else
      hn::StoreU(hn::GatherIndex(d, label_of, number), d, labels + i);
  }
  for (; i < count; ++i) labels[i] = label_of[numbers[i]];
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace epcc
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace epcc {

namespace {

HWY_EXPORT(lookUp);

constexpr int kBlock = 32;  // rows

/// Rows of the view are columns of the labels.
void lookUpTransposed(const DepthFrame& view, const std::int32_t* numbers, std::size_t stride,
                      const std::int32_t* label_of, int begin, int end, std::int32_t* labels) {
  for (int column = 0; column < view.width(); ++column)
    for (int row = begin; row < end; ++row)
      labels[view.index(row, column)] =
          label_of[numbers[static_cast<std::size_t>(row) * stride + static_cast<std::size_t>(column)]];
}

}  // namespace

void labelOfNumbers(const DepthFrame& view, const std::int32_t* numbers, std::size_t stride,
                    const std::int32_t* label_of, std::int32_t* labels, int threads) {
  const auto width = static_cast<std::size_t>(view.width());
  sharedFor((view.height() + kBlock - 1) / kBlock, threads, [&](int /*thread*/, int first, int last) {
    for (int block = first; block < last; ++block) {
      const int begin = block * kBlock, end = std::min(begin + kBlock, view.height());
      if (view.isTransposed()) {
        lookUpTransposed(view, numbers, stride, label_of, begin, end, labels);
        continue;
      }
      const auto look_up = EPCC_KERNEL(lookUp);
      for (int row = begin; row < end; ++row)
        look_up(numbers + static_cast<std::size_t>(row) * stride, width, label_of, labels + view.index(row, 0));
    }
  });
}

}  // namespace epcc
#endif
