// SPDX-License-Identifier: BSD-3-Clause
// A Sun raster is eight big-endian words, an optional colour map, and rows padded to an even length.
#include "datasets/files/sun_raster.h"

#include <array>
#include <fstream>
#include <new>

#include "datasets/support/input_error.h"

namespace epcc {

namespace {

constexpr std::uint32_t kMagic = 0x59a66a95;
constexpr std::uint8_t kFirstPlane = 10;

enum Word { kMagicWord, kWidth, kHeight, kDepth, kLength, kType, kMapType, kMapLength, kWords };
using Header = std::array<std::uint32_t, kWords>;
constexpr std::uintmax_t kHeaderSize = 4 * kWords;

bool readHeader(std::istream& in, Header& header) {
  for (std::uint32_t& word : header) {
    unsigned char bytes[4];
    if (!in.read(reinterpret_cast<char*>(bytes), sizeof bytes)) return false;
    word = 0;
    for (const unsigned char byte : bytes) word = word << 8 | byte;
  }
  return true;
}

void check(const std::string& path, const Header& header, std::uintmax_t file_size) {
  if (header[kMagicWord] != kMagic) throw InputError(path, "signature", "is not a Sun raster file");
  for (const Word side : {kWidth, kHeight})
    if (header[side] < 1 || header[side] > kMaxImageSide)
      throw InputError(path, side == kWidth ? "width" : "height",
                       std::to_string(header[side]) + " is not from 1 to " + std::to_string(kMaxImageSide));
  if (static_cast<long>(header[kWidth]) * static_cast<long>(header[kHeight]) > kMaxPixels)
    throw InputError(path, "size", "more than " + std::to_string(kMaxPixels) + " pixels");
  if (header[kDepth] != 8) throw InputError(path, "depth", std::to_string(header[kDepth]) + " bits, not 8");
  if (header[kType] > 1) throw InputError(path, "type", std::to_string(header[kType]) + " is not uncompressed (0, 1)");
  const std::uintmax_t row = header[kWidth] + header[kWidth] % 2;
  if (kHeaderSize + header[kMapLength] + row * header[kHeight] > file_size)
    throw InputError(path, "data", "is shorter than width x height");
}

}  // namespace

Image<std::uint8_t> readSunRaster(const std::string& path) try {
  const std::uintmax_t file_size = inputFileSize(path);
  std::ifstream in(path, std::ios::binary);
  Header header{};
  if (!readHeader(in, header)) throw InputError(path, "header", "is cut short");
  check(path, header, file_size);
  in.seekg(static_cast<std::streamoff>(header[kMapLength]), std::ios::cur);
  Image<std::uint8_t> image(static_cast<int>(header[kWidth]), static_cast<int>(header[kHeight]));
  for (int row = 0; row < image.height; ++row) {
    in.read(reinterpret_cast<char*>(&image.at(row, 0)), image.width);
    if (!in) throw InputError(path, "data", "cannot be read");
    in.ignore(image.width % 2);
  }
  return image;
} catch (const std::bad_alloc&) {
  throw InputError(path, "file", "needs more memory than there is");
}

bool isSunRaster(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  Header header{};
  return readHeader(in, header) && header[kMagicWord] == kMagic;
}

LabelImage readSegcompLabels(const std::string& path) {
  const Image<std::uint8_t> raw = readSunRaster(path);
  LabelImage labels(raw.width, raw.height);
  for (std::size_t i = 0; i < raw.data.size(); ++i)
    if (raw.data[i] >= kFirstPlane) labels.data[i] = raw.data[i];
  return labels;
}

}  // namespace epcc
