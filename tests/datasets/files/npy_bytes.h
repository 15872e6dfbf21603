// SPDX-License-Identifier: BSD-3-Clause
// NumPy files made by hand.
#pragma once

#include <cstring>
#include <string>
#include <vector>

namespace epcc::test {

/// Version 1.0; the header is padded to a multiple of 64 as NumPy does.
inline std::string npyFile(const std::string& dictionary, const std::string& data) {
  std::string header = dictionary;
  while ((10 + header.size() + 1) % 64 != 0) header += ' ';
  header += '\n';
  std::string bytes("\x93NUMPY\x01\x00", 8);
  bytes += static_cast<char>(header.size() & 0xff);
  bytes += static_cast<char>(header.size() >> 8);
  return bytes + header + data;
}

inline std::string npyHeader(const std::string& type, const std::string& shape) {
  return "{'descr': '" + type + "', 'fortran_order': False, 'shape': " + shape + ", }";
}

template <typename T>
std::string rawBytes(const std::vector<T>& values) {
  std::string bytes(sizeof(T) * values.size(), '\0');
  std::memcpy(bytes.data(), values.data(), bytes.size());
  return bytes;
}

}  // namespace epcc::test
