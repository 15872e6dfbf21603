// SPDX-License-Identifier: BSD-3-Clause
// Header lines in their usual order, three kinds of payload.
#include "tests/datasets/files/pcd_text.h"

#include <algorithm>

namespace epcc::test {

namespace {

HeaderLines withData(HeaderLines changes, const std::string& kind) {
  const bool given = std::any_of(changes.begin(), changes.end(), [](const auto& line) { return line.first == "DATA"; });
  if (!given) changes.emplace_back("DATA", kind);
  return changes;
}

float coordinate(int point, int axis) {
  return static_cast<float>(point) + 0.25f * static_cast<float>(axis);
}

}  // namespace

std::string pcdHeader(const HeaderLines& changes, const std::string& line_end) {
  HeaderLines lines = {{"VERSION", "0.7"}, {"FIELDS", "x y z"}, {"SIZE", "4 4 4"}, {"TYPE", "F F F"},
                       {"COUNT", "1 1 1"}, {"WIDTH", "3"},      {"HEIGHT", "2"},   {"VIEWPOINT", "0 0 0 1 0 0 0"},
                       {"POINTS", "6"},    {"DATA", "ascii"}};
  std::string text = "# .PCD v0.7 - Point Cloud Data file format" + line_end;
  for (auto& [key, value] : lines) {
    for (const auto& [changed, new_value] : changes)
      if (changed == key) value = new_value;
    if (value != "-") text += key + (value.empty() ? "" : " ") + value + line_end;
  }
  return text;
}

std::string pcdRows(int points) {
  std::string rows;
  for (int i = 0; i < points; ++i)
    rows += std::to_string(i) + " " + std::to_string(i) + ".25 " + std::to_string(i) + ".5\n";
  return rows;
}

std::string asciiPcd(const HeaderLines& changes) {
  return pcdHeader(changes) + pcdRows();
}

std::string binaryPoints() {
  std::string bytes;
  for (int i = 0; i < 6; ++i)
    for (int axis = 0; axis < 3; ++axis) append(bytes, coordinate(i, axis));
  return bytes;
}

std::string binaryFields() {
  std::string bytes;
  for (int axis = 0; axis < 3; ++axis)
    for (int i = 0; i < 6; ++i) append(bytes, coordinate(i, axis));
  return bytes;
}

std::string literalLzf(const std::string& bytes) {
  std::string packed;
  for (std::size_t at = 0; at < bytes.size(); at += 32) {
    const std::size_t length = std::min<std::size_t>(32, bytes.size() - at);
    packed += static_cast<char>(length - 1);
    packed += bytes.substr(at, length);
  }
  std::string result;
  append(result, static_cast<std::uint32_t>(packed.size()));
  append(result, static_cast<std::uint32_t>(bytes.size()));
  return result + packed;
}

std::string binaryPcd(const HeaderLines& changes) {
  return pcdHeader(withData(changes, "binary")) + binaryPoints();
}

std::string compressedPcd(const HeaderLines& changes) {
  return pcdHeader(withData(changes, "binary_compressed")) + literalLzf(binaryFields());
}

}  // namespace epcc::test
