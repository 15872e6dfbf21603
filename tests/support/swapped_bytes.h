// SPDX-License-Identifier: BSD-3-Clause
// Depth images as a reader that takes their bytes in the wrong order has them.
#pragma once

#include <cstdint>
#include <string>

#include "datasets/files/png_io.h"

namespace epcc::test {

inline std::uint16_t swappedBytes(std::uint16_t value) {
  return static_cast<std::uint16_t>(value << 8 | value >> 8);
}

inline Image<std::uint16_t> swappedBytes(Image<std::uint16_t> image) {
  for (std::uint16_t& value : image.data) value = swappedBytes(value);
  return image;
}

/// Writes a depth image anew.
inline void swapBytesOf(const std::string& png) {
  writeGray16(png, swappedBytes(readGray16(png)));
}

}  // namespace epcc::test
