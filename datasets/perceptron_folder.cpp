// SPDX-License-Identifier: BSD-3-Clause
// Text header, 512x512 words, and the two mirrors of the scanner.
#include "datasets/perceptron_folder.h"

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>

#include "datasets/folder_listing.h"
#include "datasets/input_error.h"
#include "datasets/sun_raster.h"

namespace epcc {

namespace {

namespace fs = std::filesystem;

const char kLabels[] = ".gt-seg";
const char kUnitFile[] = "perceptron.json";
constexpr int kSide = 512;
constexpr std::uintmax_t kPayload = 4 * kSide * kSide;
constexpr std::uintmax_t kLongestHeader = 4096;
constexpr int kHeaderWords = 32;
constexpr double kLongestUnit = 1.0;  // metres
constexpr unsigned kRangeBits = 0xfff;

/// perc.test.N or perc.train.N
bool isScan(const std::string& file) {
  for (const std::string prefix : {"perc.test.", "perc.train."})
    if (file.size() > prefix.size() && file.rfind(prefix, 0) == 0 &&
        file.find_first_not_of("0123456789", prefix.size()) == std::string::npos)
      return true;
  return false;
}

bool isBlank(char c) {
  return c == ' ' || (c >= '\t' && c <= '\r');
}

int wordsIn(const std::string& text) {
  int words = 0;
  for (std::size_t i = 0; i < text.size(); ++i)
    if (!isBlank(text[i]) && (i == 0 || isBlank(text[i - 1]))) ++words;
  return words;
}

/// The header is text of a fixed number of words and ends in two line ends: only then are the ranges where the size of
/// the file says they are.
void checkHeader(const std::string& path, const std::string& header) {
  const std::size_t size = header.size();
  if (wordsIn(header) != kHeaderWords || size < 2 || !isBlank(header[size - 1]) || !isBlank(header[size - 2]))
    throw InputError(path, "header", "is not that of a Perceptron scan, 32 words of text and two line ends");
}

/// 12 bits of range, the rest is reflectance.
std::vector<std::uint16_t> readRanges(const std::string& path) {
  const std::uintmax_t size = inputFileSize(path);
  if (size <= kPayload) throw InputError(path, "data", "is shorter than a header and 512x512 words of 4 bytes");
  if (size - kPayload > kLongestHeader)
    throw InputError(path, "data", "is longer than a header and 512x512 words of 4 bytes");
  std::ifstream in(path, std::ios::binary);
  std::string header(static_cast<std::size_t>(size - kPayload), '\0');
  std::vector<unsigned char> bytes(kPayload);
  in.read(header.data(), static_cast<std::streamsize>(header.size()));
  in.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  if (!in) throw InputError(path, "data", "cannot be read");
  checkHeader(path, header);
  std::vector<std::uint16_t> ranges(kSide * kSide);
  for (std::size_t i = 0; i < ranges.size(); ++i)  // big-endian
    ranges[i] = static_cast<std::uint16_t>((bytes[4 * i + 2] << 8 | bytes[4 * i + 3]) & kRangeBits);
  return ranges;
}

constexpr double radians(double degrees) {
  return degrees * 3.14159265358979323846 / 180.0;
}

}  // namespace

// After range-to-coords.c of the comparison. A ray leaves a rotating mirror (alpha, across) and then a nodding one
// (beta, up); the lengths before the mirrors belong to the measured path.
Eigen::Vector3d perceptronPoint(int row, int column, double range) {
  constexpr double beam_to_rotating = 3.0, rotating_to_nodding = 5.5;
  constexpr double field_across = radians(51.65), field_up = radians(36.73);
  constexpr double standoff = 830.3, units_per_count = 0.20236;
  constexpr double tilt = radians(45.0);  // of both mirrors in their middle positions
  const double alpha = field_across * (255.5 - column) / kSide;
  const double beta = field_up * (255.5 - row) / kSide;
  const double dz = -beam_to_rotating * (1.0 - std::cos(alpha)) / std::tan(tilt);
  const double dy = dz * std::tan(tilt + 0.5 * beta);
  const double between = rotating_to_nodding + dy;
  const double dx = between * std::tan(alpha);
  const double before = dz - rotating_to_nodding + std::hypot(dx, between);
  const double after = (range + standoff) * units_per_count - before;
  return {dx + after * std::sin(alpha), dy + after * std::cos(alpha) * std::sin(beta),
          dz + after * std::cos(alpha) * std::cos(beta)};
}

bool isPerceptronFolder(const std::string& folder) {
  return !anyFileThat(folder, isScan).empty();
}

PerceptronFolder::PerceptronFolder(const std::string& folder)
    : NamedFrames(folder, filesThat(folder, isScan), "scan perc.test.N or perc.train.N") {
  const std::string unit = (fs::path(folder) / kUnitFile).string();
  std::error_code code;
  if (!fs::exists(unit, code))
    throw InputError(unit, "file", "is missing; the scans need it to say metres_per_unit of their calibration");
  metres_per_unit_ = positiveNumber(unit, readJsonObject(unit), "metres_per_unit");
  if (metres_per_unit_ > kLongestUnit) throw InputError(unit, "metres_per_unit", "is more than 1");
}

LabelledFrame PerceptronFolder::read(std::size_t index) const {
  LabelledFrame frame;
  frame.name = name(index);
  const auto ranges = readRanges(path(index, ""));
  LabelImage labels;
  const std::string labels_path = path(index, kLabels);
  std::error_code code;
  if (fs::exists(labels_path, code)) {
    labels = readSegcompLabels(labels_path);
    if (labels.width != kSide || labels.height != kSide) throw InputError(labels_path, "size", "is not 512x512");
    frame.labels = LabelImage(kSide, kSide);
  }
  frame.depth = DepthImage(kSide, kSide);
  frame.scan.resize(3 * ranges.size(), std::nanf(""));
  for (int row = 0; row < kSide; ++row) {
    for (int column = 0; column < kSide; ++column) {
      const std::size_t from = static_cast<std::size_t>(row) * kSide + column;
      const std::size_t to = static_cast<std::size_t>(column) * kSide + (kSide - 1 - row);
      if (ranges[from] == 0) continue;
      const Eigen::Vector3d p = metres_per_unit_ * perceptronPoint(row, column, ranges[from]);
      const Eigen::Vector3d turned(p.z(), -p.y(), p.x());  // x forward, y left, z up
      for (std::size_t axis = 0; axis < 3; ++axis) frame.scan[3 * to + axis] = static_cast<float>(turned[axis]);
      frame.depth.data[to] = static_cast<float>(p.norm());
      if (!labels.empty()) frame.labels.data[to] = labels.data[from];
    }
  }
  return frame;
}

}  // namespace epcc
