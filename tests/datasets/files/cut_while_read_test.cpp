// SPDX-License-Identifier: BSD-3-Clause
// Files that another program cuts off while they are read: an error in one line, or what was there before.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <functional>

#include "datasets/files/camera_json.h"
#include "datasets/files/laser_log.h"
#include "datasets/files/npy_labels.h"
#include "datasets/files/organized_pcd.h"
#include "datasets/files/png_io.h"
#include "datasets/files/sun_raster.h"
#include "datasets/files/trajectory_file.h"
#include "tests/datasets/files/npy_bytes.h"
#include "tests/datasets/files/pcd_text.h"
#include "tests/datasets/files/segcomp_files.h"
#include "tests/support/expect_errors.h"

namespace {

/// What happens before the so many-th reading from a file; 0: nothing.
int readings_left = 0, readings = 0;
std::string cut_file;
std::uintmax_t cut_to = 0;

void cutWhenDue() {
  ++readings;
  if (readings_left > 0 && --readings_left == 0) std::filesystem::resize_file(cut_file, cut_to);
}

}  // namespace

/// Both take the C library's place in this program: streams and zlib read with the one, libpng with the other.
extern "C" __attribute__((visibility("default"))) ssize_t read(int file, void* to, std::size_t bytes) {
  cutWhenDue();
  return ::syscall(SYS_read, file, to, bytes);
}
extern "C" __attribute__((visibility("default"))) std::size_t fread(void* to, std::size_t size, std::size_t count,
                                                                    std::FILE* file) {
  cutWhenDue();
  return ::fread_unlocked(to, size, count, file);
}

namespace epcc::test {
namespace {

/// The bytes of what was read.
using Contents = std::vector<double>;

struct Format {
  const char* name;
  std::function<void(const std::string& path)> write;
  std::function<Contents(const std::string& path)> contents;
};
void PrintTo(const Format& format, std::ostream* stream) {
  *stream << format.name;
}

constexpr int kWidth = 100, kHeight = 80;

/// Noise, which takes its place in every format.
std::vector<std::uint16_t> noise(std::size_t count) {
  std::vector<std::uint16_t> values(count);
  std::uint32_t state = 1;
  for (auto& value : values) {
    state = state * 1664525u + 1013904223u;
    value = static_cast<std::uint16_t>(state >> 16);
  }
  return values;
}

template <typename Values>
Contents numbers(const Values& values) {
  return {values.begin(), values.end()};
}

void writeBytes(const std::string& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

void writePng(const std::string& path) {
  LabelImage image(kWidth, kHeight);
  image.data = noise(image.data.size());
  writeGray16(path, image);
}

std::string sizedHeader(const std::string& data) {
  return pcdHeader({{"WIDTH", std::to_string(kWidth)},
                    {"HEIGHT", std::to_string(kHeight)},
                    {"POINTS", std::to_string(kWidth * kHeight)},
                    {"DATA", data}});
}

void writeAsciiPcd(const std::string& path) {
  std::string text = sizedHeader("ascii");
  for (const std::uint16_t value : noise(kWidth * kHeight))
    text += std::to_string(value) + " 2.5 3." + std::to_string(value) + "\n";
  writeBytes(path, text);
}

void writeBinaryPcd(const std::string& path) {
  const auto values = noise(3 * kWidth * kHeight);
  writeBytes(path, sizedHeader("binary") + rawBytes(std::vector<float>(values.begin(), values.end())));
}

void writeCompressedPcd(const std::string& path) {
  const auto values = noise(3 * kWidth * kHeight);
  writeLabelledPcd(path, kWidth, kHeight, std::vector<float>(values.begin(), values.end()),
                   std::vector<std::uint32_t>(kWidth * kHeight, 7));
}

Contents cloudOf(const std::string& path) {
  return numbers(readOrganizedPcd(path).xyz);
}

void writeNpy(const std::string& path) {
  writeBytes(path, npyFile(npyHeader("<u2", "(80, 100)"), rawBytes(noise(kWidth * kHeight))));
}

void writeSun(const std::string& path) {
  const auto values = noise(512 * 512);
  writeBytes(path,
             sunRaster([&](int row, int column) { return values[static_cast<std::size_t>(512 * row + column)]; }));
}

void writePath(const std::string& path) {
  Trajectory trajectory(4000);
  for (std::size_t i = 0; i < trajectory.size(); ++i) trajectory[i].time = static_cast<double>(i);
  writeTrajectory(path, trajectory);
}

Contents posesOf(const std::string& path) {
  Contents times;
  for (const StampedPose& pose : readTrajectory(path)) times.push_back(pose.time);
  return times;
}

void writeLog(const std::string& path) {
  std::string text;
  for (const std::uint16_t value : noise(6000))
    text += "FLASER 3 1.5 2.5 " + std::to_string(value % 50) + ".5 0.1 0.2 0.3 1 2 3 10.5 host 10.6\n";
  writeBytes(path, text);
}

Contents rangesOf(const std::string& path) {
  Contents all;
  const LaserLog log = readLaserLog(path);  // a log that is cut off is of use, and says so
  if (!log.problems.empty()) throw InputError(path, "log", log.problems.back());
  for (const LaserRecord& record : log.records) all.push_back(record.scan.ranges.at(2));
  return all;
}

void writeCamera(const std::string& path) {
  CameraFile file;
  file.camera = {640, 480, 525.0, 525.0, 320.0, 240.0};
  file.extra = {{"long", std::string(100000, 'x')}};
  writeCameraJson(path, file);
}

class CutWhileReadTest : public TempFolderTest, public ::testing::WithParamInterface<Format> {};

TEST_P(CutWhileReadTest, IsAnErrorOrWhatWasThere) {
  const Format& format = GetParam();
  const std::string file = path("a");
  format.write(file);
  const std::string bytes = bytesOf(file);
  ASSERT_GT(bytes.size(), 12000U);
  readings = 0;
  const Contents whole = format.contents(file);
  const int all = readings;
  ASSERT_GT(all, 1);
  int refused = 0;
  for (const std::uintmax_t size : {std::uintmax_t{0}, bytes.size() / 2, bytes.size() - 3})
    for (int at = 1; at <= all; at += std::max(1, all / 40)) {
      writeBytes(file, bytes);
      cut_file = file;
      cut_to = size;
      readings_left = at;
      try {
        EXPECT_TRUE(format.contents(file) == whole) << "cut to " << size << " bytes before reading " << at;
      } catch (const InputError& error) {
        ++refused;
        EXPECT_EQ(std::string(error.what()).rfind(file + ": ", 0), 0U) << error.what();
        expectOneLine(error.what());
      }
      readings_left = 0;
    }
  EXPECT_GE(refused, 3);
}

INSTANTIATE_TEST_SUITE_P(
    Each, CutWhileReadTest,
    ::testing::Values(
        Format{"Png", writePng, [](const std::string& path) { return numbers(readGray16(path).data); }},
        Format{"AsciiPcd", writeAsciiPcd, cloudOf}, Format{"BinaryPcd", writeBinaryPcd, cloudOf},
        Format{"CompressedPcd", writeCompressedPcd, cloudOf},
        Format{"Npy", writeNpy,
               [](const std::string& path) { return numbers(readNpyLabels(path, kWidth, kHeight).data); }},
        Format{"SunRaster", writeSun, [](const std::string& path) { return numbers(readSunRaster(path).data); }},
        Format{"Trajectory", writePath, posesOf}, Format{"LaserLog", writeLog, rangesOf},
        Format{"Camera", writeCamera,
               [](const std::string& path) { return Contents{readCameraJson(path).camera.fx}; }}),
    [](const auto& case_info) { return std::string(case_info.param.name); });

}  // namespace
}  // namespace epcc::test
