// SPDX-License-Identifier: BSD-3-Clause
// Values of binary files, which need not lie at an aligned address.
#pragma once

#include <cstring>

namespace epcc {

/// The value of type T whose bytes, in this machine's order, start at `bytes`.
template <typename T>
double valueAs(const unsigned char* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof value);
  return static_cast<double>(value);
}

}  // namespace epcc
