// SPDX-License-Identifier: BSD-3-Clause
// The header of a PCD file, checked before anything believes it.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace epcc {

struct PcdField {
  std::string name;
  int size = 0;     ///< bytes of one element: 1, 2, 4 or 8
  char type = 'F';  ///< F, I or U
  int count = 1;    ///< elements
  int offset = 0;   ///< bytes from the start of the point
};

enum class PcdData { Ascii, Binary, BinaryCompressed };

struct PcdHeader {
  std::vector<PcdField> fields;
  int width = 0;
  int height = 0;
  PcdData data = PcdData::Ascii;
  int point_size = 0;  ///< bytes
  /// Where the sensor was and how it was turned: x, y, z and the quaternion w, x, y, z.
  std::array<double, 7> viewpoint{0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0};
  std::uintmax_t data_offset = 0;  ///< where the payload starts
  std::uintmax_t file_size = 0;    ///< bytes, before anything was read

  std::size_t points() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
  /// The field, or nullptr.
  const PcdField* field(const std::string& name) const;
};

/// Reads and checks the header of an organized cloud: every line that is needed present and in range, in 64-bit
/// arithmetic, and the payload it promises not larger than the file can hold. InputError names the line.
PcdHeader readPcdHeader(const std::string& path);

}  // namespace epcc
