// SPDX-License-Identifier: BSD-3-Clause
// Big-endian numbers of file headers made by hand.
#pragma once

#include <cstdint>
#include <string>

namespace epcc::test {

inline std::string bigEndian32(std::uint32_t value) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>((value >> shift) & 0xffU);
  return bytes;
}

}  // namespace epcc::test
