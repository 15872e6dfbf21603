// SPDX-License-Identifier: BSD-3-Clause
// PCD files made by hand, right and wrong ones.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

namespace epcc::test {

using HeaderLines = std::vector<std::pair<std::string, std::string>>;

/// Header of a 3x2 cloud of float x y z, ASCII. `changes` replaces the values of keys; "-" removes the line.
std::string pcdHeader(const HeaderLines& changes = {}, const std::string& line_end = "\n");
/// Point i is (i, i + 0.25, i + 0.5).
std::string pcdRows(int points = 6);
std::string asciiPcd(const HeaderLines& changes = {});

template <typename T>
void append(std::string& bytes, T value) {
  char raw[sizeof value];
  std::memcpy(raw, &value, sizeof value);
  bytes.append(raw, sizeof value);
}

/// The same points in binary, point after point.
std::string binaryPoints();
/// ... and field after field.
std::string binaryFields();
/// An LZF stream of literal runs alone, behind its two sizes.
std::string literalLzf(const std::string& bytes);

std::string binaryPcd(const HeaderLines& changes = {});
std::string compressedPcd(const HeaderLines& changes = {});

}  // namespace epcc::test
