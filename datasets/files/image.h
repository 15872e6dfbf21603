// SPDX-License-Identifier: BSD-3-Clause
// Row-major images of the data sets.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace epcc {

/// Row-major image, data.size() == width * height.
template <typename T>
struct Image {
  int width = 0;
  int height = 0;
  std::vector<T> data;

  Image() = default;
  Image(int image_width, int image_height, T value = T())
      : width(image_width),
        height(image_height),
        data(static_cast<std::size_t>(image_width) * static_cast<std::size_t>(image_height), value) {}
  bool empty() const { return data.empty(); }
  T& at(int row, int column) { return data[static_cast<std::size_t>(row) * width + column]; }
  const T& at(int row, int column) const { return data[static_cast<std::size_t>(row) * width + column]; }
};

/// Metres along the optical axis, 0 = invalid.
using DepthImage = Image<float>;
/// 0 not a plane, 1..K plane, 65535 ignore.
using LabelImage = Image<std::uint16_t>;
constexpr std::uint16_t kIgnoreLabel = 65535;

struct Rgb {
  std::uint8_t r = 0, g = 0, b = 0;
};
using ColorImage = Image<Rgb>;

/// Limits of every reader: 16384 pixels a side, 64 million in all.
constexpr int kMaxImageSide = 16384;
constexpr long kMaxPixels = 64L * 1000 * 1000;

/// "640x480", for messages.
inline std::string sizeText(int width, int height) {
  return std::to_string(width) + "x" + std::to_string(height);
}

}  // namespace epcc
