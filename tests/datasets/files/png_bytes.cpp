// SPDX-License-Identifier: BSD-3-Clause
// Chunks, checksums and Adam7 by hand; zlib compresses.
#include "tests/datasets/files/png_bytes.h"

#include <zlib.h>

namespace epcc::test {

namespace {

std::string bigEndian16(std::uint16_t value) {
  return {static_cast<char>(value >> 8), static_cast<char>(value & 0xff)};
}

std::uint32_t checksum(const char* bytes, std::size_t size) {
  return static_cast<std::uint32_t>(::crc32(0, reinterpret_cast<const Bytef*>(bytes), static_cast<uInt>(size)));
}

std::string compressed(const std::string& bytes) {
  uLongf size = ::compressBound(static_cast<uLong>(bytes.size()));
  std::string result(size, '\0');
  ::compress(reinterpret_cast<Bytef*>(result.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
             static_cast<uLong>(bytes.size()));
  result.resize(size);
  return result;
}

std::uint32_t readBigEndian32(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
  return value;
}

}  // namespace

const std::string kPngSignature("\x89PNG\r\n\x1a\n", 8);

std::string pngChunk(const std::string& type, const std::string& data) {
  const std::string body = type + data;
  return bigEndian32(static_cast<std::uint32_t>(data.size())) + body + bigEndian32(checksum(body.data(), body.size()));
}

std::string pngBytes(const PngRecipe& recipe) {
  std::string header = bigEndian32(recipe.width) + bigEndian32(recipe.height);
  header += static_cast<char>(recipe.bit_depth);
  header += static_cast<char>(recipe.color_type);
  header += std::string(2, '\0');  // deflate, adaptive filters
  header += static_cast<char>(recipe.interlace);
  return kPngSignature + pngChunk("IHDR", header) + recipe.before_image +
         pngChunk("IDAT", compressed(recipe.scan_lines)) + pngChunk("IEND", "");
}

std::string grayScanLines(const std::vector<std::uint16_t>& values, std::uint32_t width) {
  std::string bytes;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i % width == 0) bytes += '\0';
    bytes += bigEndian16(values[i]);
  }
  return bytes;
}

std::string adam7ScanLines(const std::vector<std::uint16_t>& values, std::uint32_t width) {
  struct Pass {
    std::size_t x, y, dx, dy;
  };
  constexpr Pass kPasses[] = {{0, 0, 8, 8}, {4, 0, 8, 8}, {0, 4, 4, 8}, {2, 0, 4, 4},
                              {0, 2, 2, 4}, {1, 0, 2, 2}, {0, 1, 1, 2}};
  std::string bytes;
  for (const Pass& pass : kPasses) {
    if (pass.x >= width) continue;
    for (std::size_t y = pass.y; y < values.size() / width; y += pass.dy) {
      bytes += '\0';
      for (std::size_t x = pass.x; x < width; x += pass.dx) bytes += bigEndian16(values[y * width + x]);
    }
  }
  return bytes;
}

std::vector<std::uint16_t> grayValues() {
  return {0, 1, 65535, 256, 255, 1000, 2000, 3000, 4000, 5000, 65534, 32768, 32767, 12345, 54321};
}

PngRecipe grayRecipe() {
  PngRecipe recipe;
  recipe.scan_lines = grayScanLines(grayValues(), recipe.width);
  return recipe;
}

void repairChecksums(std::string& png) {
  for (std::size_t at = 8; at + 12 <= png.size();) {
    const std::size_t length = readBigEndian32(png, at);
    if (length > png.size() - at - 12) return;
    png.replace(at + 8 + length, 4, bigEndian32(checksum(png.data() + at + 4, length + 4)));
    at += length + 12;
  }
}

}  // namespace epcc::test
