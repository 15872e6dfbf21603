// SPDX-License-Identifier: BSD-3-Clause
// Transposes in blocks of four by four, what is left at the margins value by value.
#include "vector/transpose.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "vector/transpose.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "vector/dispatch.h"

HWY_BEFORE_NAMESPACE();
namespace epcc {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

template <typename T>
HWY_INLINE void transposeBlock(const T* from, std::size_t from_pitch, T* to, std::size_t to_pitch) {
  const hn::CappedTag<T, 4> d;
  const hn::Repartition<double, decltype(d)> pairs;
  const auto a = hn::LoadU(d, from);
  const auto b = hn::LoadU(d, from + from_pitch);
  const auto c = hn::LoadU(d, from + 2 * from_pitch);
  const auto e = hn::LoadU(d, from + 3 * from_pitch);
  const auto ab_low = hn::BitCast(pairs, hn::InterleaveLower(d, a, b));
  const auto ab_high = hn::BitCast(pairs, hn::InterleaveUpper(d, a, b));
  const auto ce_low = hn::BitCast(pairs, hn::InterleaveLower(d, c, e));
  const auto ce_high = hn::BitCast(pairs, hn::InterleaveUpper(d, c, e));
  hn::StoreU(hn::BitCast(d, hn::InterleaveLower(pairs, ab_low, ce_low)), d, to);
  hn::StoreU(hn::BitCast(d, hn::InterleaveUpper(pairs, ab_low, ce_low)), d, to + to_pitch);
  hn::StoreU(hn::BitCast(d, hn::InterleaveLower(pairs, ab_high, ce_high)), d, to + 2 * to_pitch);
  hn::StoreU(hn::BitCast(d, hn::InterleaveUpper(pairs, ab_high, ce_high)), d, to + 3 * to_pitch);
}

template <typename T>
HWY_INLINE void transposeAll(const T* from, std::size_t from_pitch, std::size_t rows, std::size_t columns, T* to,
                             std::size_t to_pitch) {
  const std::size_t whole_rows = rows - rows % 4;
  const std::size_t whole_columns = columns - columns % 4;
  for (std::size_t column = 0; column < whole_columns; column += 4)
    for (std::size_t row = 0; row < whole_rows; row += 4)
      transposeBlock(from + row * from_pitch + column, from_pitch, to + column * to_pitch + row, to_pitch);
  for (std::size_t row = 0; row < rows; ++row)
    for (std::size_t column = row < whole_rows ? whole_columns : 0; column < columns; ++column)
      to[column * to_pitch + row] = from[row * from_pitch + column];
}

void transposeFloats(const float* from, std::size_t from_pitch, std::size_t rows, std::size_t columns, float* to,
                     std::size_t to_pitch) {
  transposeAll(from, from_pitch, rows, columns, to, to_pitch);
}

void transposeInts(const std::int32_t* from, std::size_t from_pitch, std::size_t rows, std::size_t columns,
                   std::int32_t* to, std::size_t to_pitch) {
  transposeAll(from, from_pitch, rows, columns, to, to_pitch);
}

}  // namespace HWY_NAMESPACE
}  // namespace epcc
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace epcc {

HWY_EXPORT(transposeFloats);
HWY_EXPORT(transposeInts);

void transpose(const float* from, std::size_t from_pitch, int rows, int columns, float* to, std::size_t to_pitch) {
  EPCC_KERNEL(transposeFloats)
  (from, from_pitch, static_cast<std::size_t>(rows), static_cast<std::size_t>(columns), to, to_pitch);
}

void transpose(const std::int32_t* from, std::size_t from_pitch, int rows, int columns, std::int32_t* to,
               std::size_t to_pitch) {
  EPCC_KERNEL(transposeInts)
  (from, from_pitch, static_cast<std::size_t>(rows), static_cast<std::size_t>(columns), to, to_pitch);
}

}  // namespace epcc
#endif
