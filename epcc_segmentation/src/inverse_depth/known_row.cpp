// SPDX-License-Identifier: BSD-3-Clause
// Block by block: one plane, and a comparison in each lane; or each sample its own.
#include "inverse_depth/known_row.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "inverse_depth/known_row.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>

#include "inverse_depth/uniform_block-inl.h"
#include "vector/dispatch.h"

HWY_BEFORE_NAMESPACE();
namespace epcc {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Of a block that expects one plane.
HWY_INLINE std::size_t TakeOne(const KnownRow& row, int column, const KnownRowPlane& plane, std::int32_t expected,
                               std::int32_t* labels) {
  const hn::CappedTag<float, kKnownBlock> d;
  const hn::Rebind<std::int32_t, decltype(d)> di;
  const auto x = hn::Set(d, plane.x), rest = hn::Set(d, plane.y * row.along + plane.z);
  const auto limit = hn::Set(d, plane.max_square);
  std::size_t count = 0;
  for (int k = column; k < column + kKnownBlock; k += static_cast<int>(hn::MaxLanes(d))) {
    const auto on_plane = hn::Add(hn::Mul(x, hn::LoadU(d, row.across + k)), rest);
    const auto residual = hn::Sub(hn::LoadU(d, row.w + k), on_plane);
    const auto square = hn::Mul(hn::Mul(residual, residual), hn::LoadU(d, row.weight + k));
    const auto before = hn::LoadU(di, labels + k);
    const auto takes = hn::And(hn::RebindMask(di, hn::Le(square, limit)), hn::Eq(before, hn::Zero(di)));
    hn::StoreU(hn::IfThenElse(takes, hn::Set(di, expected), before), di, labels + k);
    count += hn::CountTrue(di, takes);
  }
  return count;
}

HWY_INLINE std::size_t TakeEach(const KnownRow& row, int begin, int end, const KnownRowPlane* planes,
                                const std::int32_t* expected, std::int32_t* labels) {
  std::size_t count = 0;
  for (int k = begin; k < end; ++k) {
    const KnownRowPlane& plane = planes[std::max(expected[k], 0)];
    const float residual = row.w[k] - (plane.x * row.across[k] + (plane.y * row.along + plane.z));
    const bool takes = (labels[k] == 0) & (residual * residual * row.weight[k] <= plane.max_square);
    labels[k] = takes ? expected[k] : labels[k];
    count += takes ? 1 : 0;
  }
  return count;
}

std::size_t TakeExpected(const KnownRow* row, const KnownRowPlane* planes, const std::int32_t* expected,
                         std::int32_t* labels) {
  std::size_t count = 0;
  int k = 0;
  for (; k + kKnownBlock <= row->count; k += kKnownBlock) {
    if (!isUniform<kKnownBlock>(expected + k))
      count += TakeEach(*row, k, k + kKnownBlock, planes, expected, labels);
    else if (expected[k] > 0)
      count += TakeOne(*row, k, planes[expected[k]], expected[k], labels);
  }
  return count + TakeEach(*row, k, row->count, planes, expected, labels);
}

}  // namespace HWY_NAMESPACE
}  // namespace epcc
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace epcc {

HWY_EXPORT(TakeExpected);

std::size_t takeExpected(const KnownRow& row, const KnownRowPlane* planes, const std::int32_t* expected,
                         std::int32_t* labels) {
  return EPCC_KERNEL(TakeExpected)(&row, planes, expected, labels);
}

}  // namespace epcc
#endif
