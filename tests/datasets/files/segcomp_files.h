// SPDX-License-Identifier: BSD-3-Clause
// Files of the SegComp comparison made by hand.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "tests/support/big_endian.h"

namespace epcc::test {

struct SunRecipe {
  std::uint32_t magic = 0x59a66a95;
  std::uint32_t width = 512;
  std::uint32_t height = 512;
  std::uint32_t depth = 8;
  std::uint32_t length = 512 * 512;
  std::uint32_t type = 0;
  std::uint32_t map_type = 0;
  std::uint32_t map_length = 0;
};

inline std::string sunHeader(const SunRecipe& recipe) {
  return bigEndian32(recipe.magic) + bigEndian32(recipe.width) + bigEndian32(recipe.height) +
         bigEndian32(recipe.depth) + bigEndian32(recipe.length) + bigEndian32(recipe.type) +
         bigEndian32(recipe.map_type) + bigEndian32(recipe.map_length);
}

/// 512x512 pixels, `value` gives that of (row, column).
inline std::string sunRaster(const std::function<int(int, int)>& value) {
  std::string bytes = sunHeader({});
  for (int row = 0; row < 512; ++row)
    for (int column = 0; column < 512; ++column) bytes += static_cast<char>(value(row, column));
  return bytes;
}

}  // namespace epcc::test
