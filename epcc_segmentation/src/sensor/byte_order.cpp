// SPDX-License-Identifier: BSD-3-Clause
// How rough neighbouring 16-bit values are, as they are and with their bytes swapped.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

#include "epcc_segmentation/doubts.h"

namespace epcc {

namespace {

constexpr int kRows = 12;  // that are looked at, or a few more
constexpr std::uint32_t kNoDepth = 65535;
constexpr std::int64_t kEnoughPairs = 100;
// Images of depth are 4 to 420 times smoother than with their bytes swapped, noise is as rough.
constexpr double kSmoother = 2.0;

std::uint32_t swapped(std::uint32_t value) {
  return (value & 0xffU) << 8U | value >> 8U;
}

/// Sums over pairs of neighbours.
struct Roughness {
  std::int64_t differences = 0;
  std::int64_t values = 0;

  /// Adds them if `counts` is 1.
  void add(std::uint32_t a, std::uint32_t b, std::uint32_t counts) {
    differences += counts * (std::max(a, b) - std::min(a, b));
    values += counts * (a + b);
  }
  double relative() const { return values > 0 ? static_cast<double>(differences) / static_cast<double>(values) : 0.0; }
};

}  // namespace

bool bytesAreSwapped(const DepthView<std::uint16_t>& depth) {
  if (depth.data == nullptr || depth.width < 2 || depth.height < 1) return false;
  const auto width = static_cast<std::size_t>(depth.width);
  const std::ptrdiff_t stride =
      depth.row_stride != 0 ? depth.row_stride : static_cast<std::ptrdiff_t>(width * sizeof(std::uint16_t));
  Roughness as_read, other_way_round;
  std::int64_t pairs = 0;
  const int step = std::max(1, depth.height / kRows);
  for (int row = step / 2; row < depth.height; row += step) {
    const char* values = reinterpret_cast<const char*>(depth.data) + row * stride;
    const auto valueAt = [values](std::size_t i) {
      std::uint16_t value;  // it need not be aligned
      std::memcpy(&value, values + i * sizeof value, sizeof value);
      return static_cast<std::uint32_t>(value);
    };
    for (std::size_t i = 0; i + 1 < width; ++i) {
      const std::uint32_t a = valueAt(i), b = valueAt(i + 1);
      const std::uint32_t counts = ((a != 0) & (b != 0) & (a != kNoDepth) & (b != kNoDepth)) ? 1U : 0U;
      pairs += counts;
      as_read.add(a, b, counts);
      other_way_round.add(swapped(a), swapped(b), counts);
    }
  }
  return pairs >= kEnoughPairs && as_read.relative() > kSmoother * other_way_round.relative();
}

}  // namespace epcc
