// SPDX-License-Identifier: BSD-3-Clause
// Generated inputs, and starting the program.
#include "tests/eval/segment/tool_runner.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include "datasets/files/png_io.h"

namespace epcc::test {
namespace {

namespace fs = std::filesystem;

constexpr int kWidth = 64;
constexpr int kHeight = 48;
constexpr double kFocal = 60.0;
constexpr double kCx = 31.5;
constexpr double kCy = 23.5;

double roomDepth(int row) {
  const double wall = 2.0;
  const double down = (row - kCy) / kFocal;
  return down > 0.0 ? std::min(wall, 0.35 / down) : wall;
}

std::uint32_t crc32(const std::string& bytes) {
  std::uint32_t crc = 0xFFFFFFFFU;
  for (const char c : bytes) {
    crc ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1U) != 0 ? 0xEDB88320U : 0U);
  }
  return ~crc;
}

void putBigEndian(std::string& bytes, std::size_t offset, std::uint32_t value, int count) {
  for (int i = 0; i < count; ++i) {
    bytes[offset + static_cast<std::size_t>(i)] = static_cast<char>((value >> (8 * (count - 1 - i))) & 0xFFU);
  }
}

}  // namespace

ToolResult SegmentToolTest::run(const std::vector<std::string>& arguments) const {
  return runTool("epcc_segment", arguments, folder());
}

void SegmentToolTest::expectFailure(const std::vector<std::string>& arguments, int exit_code,
                                    const std::string& words) const {
  test::expectFailure(run(arguments), "epcc_segment", exit_code, words);
}

void SegmentToolTest::writeFrame(const std::string& name) const {
  writeDepth(name + "_depth.png");
  writeCamera(name + ".json");
}

void SegmentToolTest::writeDepth(const std::string& name) const {
  LabelImage image;
  image.width = kWidth;
  image.height = kHeight;
  for (int row = 0; row < kHeight; ++row) {
    const auto value = static_cast<std::uint16_t>(std::lround(1e3 * roomDepth(row)));
    image.data.insert(image.data.end(), kWidth, value);
  }
  fs::create_directories(fs::path(path(name)).parent_path());
  writeGray16(path(name), image);
}

void SegmentToolTest::writeCamera(const std::string& name, int width, int height, const std::string& more) const {
  std::ostringstream text;
  text << "{\"width\": " << width << ", \"height\": " << height << ", \"fx\": " << kFocal << ", \"fy\": " << kFocal
       << ", \"cx\": " << kCx << ", \"cy\": " << kCy << ", \"depth_scale\": 0.001" << more << "}\n";
  write(name, text.str());
}

void SegmentToolTest::writeCloud(const std::string& name, bool flipped) const {
  const double sign = flipped ? -1.0 : 1.0;
  std::ostringstream text;
  text << "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH " << kWidth << "\nHEIGHT " << kHeight
       << "\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " << kWidth * kHeight << "\nDATA ascii\n";
  for (int row = 0; row < kHeight; ++row) {
    for (int column = 0; column < kWidth; ++column) {
      const double z = roomDepth(row);
      text << z * (column - kCx) / kFocal << ' ' << sign * z * (row - kCy) / kFocal << ' ' << sign * z << '\n';
    }
  }
  write(name, text.str());
}

void SegmentToolTest::patchPngHeader(const std::string& name, std::size_t offset, std::uint32_t value,
                                     int bytes) const {
  // 8 signature, 4 length, "IHDR" at 12, 13 bytes of data at 16, check sum at 29.
  std::string content = read(name);
  ASSERT_GE(content.size(), 33U);
  putBigEndian(content, offset, value, bytes);
  putBigEndian(content, 29, crc32(content.substr(12, 17)), 4);
  write(name, content);
}

}  // namespace epcc::test
