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

/// Bit i: a[i] != b[i], of 16 labels.
HWY_INLINE std::uint64_t compareBlock(const std::int32_t* HWY_RESTRICT a, const std::int32_t* HWY_RESTRICT b) {
#if HWY_TARGET == HWY_EMU128
  // Masks are slow without instructions for them, but most blocks have no border.
  std::int32_t any = 0;
  for (std::size_t i = 0; i < kBlock; ++i) any |= a[i] ^ b[i];
  return any == 0 ? 0 : compareSingly(a, b, kBlock);
#else
  const hn::CappedTag<std::int32_t, kBlock> d;
  constexpr std::size_t kLanes = hn::MaxLanes(d);
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < kBlock; i += kLanes) {
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(d, hn::Ne(hn::LoadU(d, a + i), hn::LoadU(d, b + i)), bytes);
    bits |= (static_cast<std::uint64_t>(bytes[0]) | static_cast<std::uint64_t>(bytes[1]) << 8) << i;
  }
  return bits;
#endif
}

/// Bit i of the words: a[i] != b[step i], of `count` labels. The last block overlaps the one before.
void compareLabels(const std::int32_t* a, const std::int32_t* b, std::size_t step, std::size_t count,
                   std::uint64_t* bits) {
  for (std::size_t word = 0; word * kWord < count; ++word) bits[word] = 0;
  if (count < kBlock) {
    for (std::size_t i = 0; i < count; ++i) bits[0] |= compareSingly(a + i, b + step * i, 1) << i;
    return;
  }
  for (std::size_t i = 0; i + kBlock <= count; i += kBlock)
    bits[i / kWord] |= compareBlock(a + i, b + step * i) << i % kWord;
  const std::size_t last = count - kBlock;
  const std::uint64_t block = compareBlock(a + last, b + step * last);
  const std::size_t shift = last % kWord;
  bits[last / kWord] |= block << shift;
  if (shift > kWord - kBlock) bits[last / kWord + 1] |= block >> (kWord - shift);
}

}  // namespace HWY_NAMESPACE
}  // namespace epcc
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace epcc {

HWY_EXPORT(compareLabels);

void RowBorders::resize(int width) {
  const std::size_t words = (static_cast<std::size_t>(width) + 63) / 64;
  for (RowBits* bits : {&left, &above, &labelled}) bits->assign(words, 0);
}

// From "not that of the next pixel" to "not that of the pixel before".
void markLeftBorders(const std::int32_t* labels, int width, int row, RowBits& left) {
  const auto count = static_cast<std::size_t>(width);
  const std::int32_t* here = labels + static_cast<std::size_t>(row) * count;
  left.back() = 0;
  EPCC_KERNEL(compareLabels)(here, here + 1, 1, count - 1, left.data());
  std::uint64_t carry = 0;
  for (std::uint64_t& word : left) {
    const std::uint64_t shifted = word << 1 | carry;
    carry = word >> 63;
    word = shifted;
  }
}

void markBorders(const std::int32_t* labels, int width, int row, RowBorders& borders) {
  static constexpr std::int32_t kNone[16] = {};
  const auto count = static_cast<std::size_t>(width);
  const std::int32_t* here = labels + static_cast<std::size_t>(row) * count;
  const auto compare = EPCC_KERNEL(compareLabels);
  markLeftBorders(labels, width, row, borders.left);
  compare(here, kNone, 0, count, borders.labelled.data());
  if (row > 0)
    compare(here, here - count, 1, count, borders.above.data());
  else
    borders.above.assign(borders.above.size(), 0);
}

}  // namespace epcc
#endif  // HWY_ONCE
