// SPDX-License-Identifier: BSD-3-Clause
// A row of labels is compared with itself, one pixel on, with the row above and with 0, sixteen pixels at a time.
#include "inverse_depth/label_borders.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "inverse_depth/label_borders.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "vector/dispatch.h"

HWY_BEFORE_NAMESPACE();
namespace epcc {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

constexpr std::size_t kBlock = 16;  // labels
constexpr std::size_t kWord = 64;   // bits

/// Bit i: a[i] != b[i], of `count` labels.
std::uint64_t compareSingly(const std::int32_t* a, const std::int32_t* b, std::size_t count) {
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < count; ++i) bits |= static_cast<std::uint64_t>(a[i] != b[i] ? 1 : 0) << i;
  return bits;
}

/// Bit i: a[i] != b[i], of 16 labels, in two bytes.
HWY_INLINE void compareBlock(const std::int32_t* a, const std::int32_t* b, std::uint8_t* bytes) {
#if HWY_TARGET == HWY_EMU128
  // Without instructions for masks each label brings its bit, and they are summed.
  static constexpr std::int32_t kBit[kBlock] = {1,      1 << 1, 1 << 2,  1 << 3,  1 << 4,  1 << 5,  1 << 6,  1 << 7,
                                                1 << 8, 1 << 9, 1 << 10, 1 << 11, 1 << 12, 1 << 13, 1 << 14, 1 << 15};
  const hn::CappedTag<std::int32_t, kBlock> d;
  auto sum = hn::Zero(d);
  for (std::size_t i = 0; i < kBlock; i += hn::MaxLanes(d)) {
    const auto differs = hn::Ne(hn::LoadU(d, a + i), hn::LoadU(d, b + i));
    sum = hn::Or(sum, hn::IfThenElseZero(differs, hn::LoadU(d, kBit + i)));
  }
  std::int32_t parts[hn::MaxLanes(d)];
  hn::StoreU(sum, d, parts);
  std::int32_t bits = 0;
  for (const std::int32_t part : parts) bits |= part;
  bytes[0] = static_cast<std::uint8_t>(bits & 0xff);
  bytes[1] = static_cast<std::uint8_t>(bits >> 8);
#else
  const hn::CappedTag<std::int32_t, kBlock> d;
  constexpr std::size_t kLanes = hn::MaxLanes(d);
  constexpr std::size_t kSteps = kBlock / kLanes;
  std::uint8_t parts[kSteps + 7];  // more than a byte may be written
  for (std::size_t k = 0; k < kSteps; ++k) {
    const auto differs = hn::Ne(hn::LoadU(d, a + k * kLanes), hn::LoadU(d, b + k * kLanes));
    hn::StoreMaskBits(d, differs, parts + k);
  }
  bytes[0] = kLanes == 4 ? static_cast<std::uint8_t>(parts[0] | parts[1 % kSteps] << 4) : parts[0];
  bytes[1] = kLanes == 4 ? static_cast<std::uint8_t>(parts[2 % kSteps] | parts[3 % kSteps] << 4) : parts[1];
#endif
}

/// Bit i of the words: a[i] != b[step i], of `count` labels.
void compareLabels(const std::int32_t* a, const std::int32_t* b, std::size_t step, std::size_t count,
                   std::uint64_t* bits) {
  std::size_t i = 0;
  for (std::size_t word = 0; word * kWord < count; ++word) {
    std::uint8_t bytes[kWord / 8] = {};
    for (std::size_t k = 0; k < kWord && i + kBlock <= count; k += kBlock, i += kBlock)
      compareBlock(a + i, b + step * i, bytes + k / 8);
    std::uint64_t whole = 0;
    for (std::size_t k = 0; k < sizeof(bytes); ++k) whole |= static_cast<std::uint64_t>(bytes[k]) << 8 * k;
    bits[word] = whole;
  }
  for (; i < count; ++i) bits[i / kWord] |= compareSingly(a + i, b + step * i, 1) << i % kWord;
}

}  // namespace HWY_NAMESPACE
}  // namespace epcc
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace epcc {

HWY_EXPORT(compareLabels);

namespace {

const std::int32_t* rowOf(const std::int32_t* labels, int width, int row) {
  return labels + static_cast<std::size_t>(row) * static_cast<std::size_t>(width);
}

}  // namespace

// From "not that of the next pixel" to "not that of the pixel before". What follows the last pixel of a row is the next
// row, except at the end.
void markLeftBorders(const std::int32_t* labels, int width, int height, int row, RowBits& bits) {
  const std::int32_t* here = rowOf(labels, width, row);
  const int count = row + 1 < height ? width : width - 1;
  bits.back() = 0;
  EPCC_KERNEL(compareLabels)(here, here + 1, 1, static_cast<std::size_t>(count), bits.data());
  std::uint64_t carry = 0;
  for (std::uint64_t& word : bits) {
    const std::uint64_t shifted = word << 1 | carry;
    carry = word >> 63;
    word = shifted;
  }
  if (width % 64 != 0) bits.back() &= (std::uint64_t{1} << width % 64) - 1;
}

void markUpperBorders(const std::int32_t* labels, int width, int row, RowBits& bits) {
  const std::int32_t* here = rowOf(labels, width, row);
  if (row > 0)
    EPCC_KERNEL(compareLabels)(here, here - width, 1, static_cast<std::size_t>(width), bits.data());
  else
    bits.assign(bits.size(), 0);
}

void markLabelled(const std::int32_t* labels, int width, int row, RowBits& bits) {
  static constexpr std::int32_t kNone[16] = {};
  EPCC_KERNEL(compareLabels)(rowOf(labels, width, row), kNone, 0, static_cast<std::size_t>(width), bits.data());
}

}  // namespace epcc
#endif  // HWY_ONCE
