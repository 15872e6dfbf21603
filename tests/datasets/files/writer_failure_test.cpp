// SPDX-License-Identifier: BSD-3-Clause
// Each writer, when it cannot write: one OutputError, the old file untouched, nothing left behind.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <functional>

#include "datasets/files/camera_json.h"
#include "datasets/files/organized_pcd.h"
#include "datasets/files/plane_list.h"
#include "datasets/files/png_io.h"
#include "datasets/files/segment_list.h"
#include "datasets/support/atomic_file.h"
#include "tests/support/expect_errors.h"

namespace epcc {
namespace {

struct Writer {
  const char* name;
  std::function<void(const std::string&)> write;
};
void PrintTo(const Writer& writer, std::ostream* stream) {
  *stream << writer.name;
}

/// Noise, which no writer can make small.
template <typename T>
T noise(int width, int height) {
  T image(width, height);
  std::uint32_t state = 1;
  for (auto& value : image.data) {
    state = state * 1664525u + 1013904223u;
    const auto byte = static_cast<std::uint8_t>(state >> 24);
    if constexpr (std::is_same_v<T, ColorImage>)
      value = {byte, static_cast<std::uint8_t>(state >> 16), static_cast<std::uint8_t>(state >> 8)};
    else
      value = static_cast<std::uint16_t>(state >> 16);
  }
  return image;
}

void writeCamera(const std::string& path) {
  CameraFile file;
  file.camera = {640, 480, 525.0, 525.0, 320.0, 240.0};
  file.extra = {{"long", std::string(100000, 'x')}};
  writeCameraJson(path, file);
}

void writePlanes(const std::string& path) {
  PlaneSegmentation many;
  many.width = many.height = 1;
  many.labels = {0};
  many.planes.resize(500);
  writePlaneList(path, many);
}

void writeCloud(const std::string& path) {
  const auto values = noise<LabelImage>(60, 50);
  std::vector<float> xyz;
  for (int i = 0; i < 3; ++i) xyz.insert(xyz.end(), values.data.begin(), values.data.end());
  writeLabelledPcd(path, 60, 50, xyz, std::vector<std::uint32_t>(values.data.begin(), values.data.end()));
}

class WriterFailureTest : public test::TempFolderTest, public ::testing::WithParamInterface<Writer> {
 protected:
  void expectFailure(const std::string& file, const std::string& field, const std::string& part) const {
    test::expectError<OutputError>([&] { GetParam().write(file); }, file, field, part);
  }
};

TEST_P(WriterFailureTest, WritesIfNothingIsWrong) {
  GetParam().write(path("out"));
  EXPECT_EQ(names(), std::vector<std::string>{"out"});
  EXPECT_GT(std::filesystem::file_size(path("out")), 2000u);
}

TEST_P(WriterFailureTest, LongestNameOfTheFileSystemIsFine) {
  const std::string name(255, 'n');
  GetParam().write(path(name));
  EXPECT_EQ(names(), std::vector<std::string>{name});
}

TEST_P(WriterFailureTest, NameTooLong) {
  expectFailure(path(std::string(256, 'n')), "file", "");
  EXPECT_TRUE(names().empty());
}

TEST_P(WriterFailureTest, MissingFolder) {
  expectFailure(path("no/out"), "folder", "does not exist");
}

TEST_P(WriterFailureTest, FolderIsAFile) {
  expectFailure(write("a", "x") + "/out", "folder", "does not exist");
}

TEST_P(WriterFailureTest, TargetIsAFolder) {
  std::filesystem::create_directory(path("out"));
  expectFailure(path("out"), "file", "is a folder");
  EXPECT_EQ(names(), std::vector<std::string>{"out"});
}

TEST_P(WriterFailureTest, TargetIsADevice) {
  expectFailure("/dev/null", "file", "not a regular file");
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

TEST_P(WriterFailureTest, EmptyName) {
  expectFailure("", "file", "");
}

TEST_P(WriterFailureTest, PlaceThatNobodyMayWriteTo) {
  expectFailure("/proc/out", "file", "");
}

TEST_P(WriterFailureTest, ReadOnlyFolder) {
  using std::filesystem::perms;
  write("out", "old");
  std::filesystem::permissions(folder(),
                               perms::owner_read | perms::owner_exec | perms::others_read | perms::others_exec);
  // The superuser may write everywhere, nobody may not.
  const uid_t user = ::geteuid();
  ASSERT_TRUE(user != 0 || ::seteuid(65534) == 0);
  expectFailure(path("out"), "file", "");
  ASSERT_EQ(::seteuid(user), 0);
  std::filesystem::permissions(folder(), perms::owner_all);
  EXPECT_EQ(test::bytesOf(path("out")), "old");
  EXPECT_EQ(names(), std::vector<std::string>{"out"});
}

TEST_P(WriterFailureTest, DiskFullKeepsTheOldFileAndLeavesNothing) {
  write("out", "old");
  std::signal(SIGXFSZ, SIG_IGN);
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  rlimit small = before;
  small.rlim_cur = 1000;
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  std::string error;
  try {
    GetParam().write(path("out"));
  } catch (const OutputError& caught) {
    error = caught.what();
  }
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &before), 0);
  EXPECT_EQ(error.substr(0, path("out").size() + 2), path("out") + ": ");
  test::expectOneLine(error);
  EXPECT_EQ(test::bytesOf(path("out")), "old");
  EXPECT_EQ(names(), std::vector<std::string>{"out"});
}

INSTANTIATE_TEST_SUITE_P(
    Each, WriterFailureTest,
    ::testing::Values(Writer{"Gray16", [](const std::string& path) { writeGray16(path, noise<LabelImage>(50, 40)); }},
                      Writer{"Rgb", [](const std::string& path) { writeRgb(path, noise<ColorImage>(50, 40)); }},
                      Writer{"Text", [](const std::string& path) { writeTextFile(path, std::string(100000, 'x')); }},
                      Writer{"Camera", writeCamera}, Writer{"PlaneList", writePlanes},
                      Writer{"SegmentList",
                             [](const std::string& path) { writeSegmentList(path, std::vector<LineSegment>(2000)); }},
                      Writer{"LabelledPcd", writeCloud}),
    [](const auto& case_info) { return std::string(case_info.param.name); });

class WriterSizeTest : public test::TempFolderTest {};

TEST_F(WriterSizeTest, EmptyImages) {
  const std::string file = path("a.png");
  test::expectError<OutputError>([&] { writeGray16(file, LabelImage()); }, file, "size", "empty image");
  test::expectError<OutputError>([&] { writeRgb(file, ColorImage()); }, file, "size", "empty image");
  test::expectError<OutputError>([&] { writeGray16(file, LabelImage(0, 5)); }, file, "size", "empty image");
  EXPECT_TRUE(names().empty());
}

TEST_F(WriterSizeTest, ImageWithFewerPixelsThanItsSize) {
  LabelImage image(5, 5);
  image.data.resize(24);
  test::expectError<OutputError>([&] { writeGray16(path("a.png"), image); }, path("a.png"), "size", "number of pixels");
  EXPECT_TRUE(names().empty());
}

TEST_F(WriterSizeTest, CloudsWhosePointsDoNotFit) {
  const std::string file = path("a.pcd");
  const auto refused = [&](int width, int height, std::size_t values, std::size_t labels) {
    test::expectError<OutputError>(
        [&] { writeLabelledPcd(file, width, height, std::vector<float>(values), std::vector<std::uint32_t>(labels)); },
        file, "size", "do not match");
  };
  refused(0, 0, 0, 0);
  refused(-2, -3, 18, 6);
  refused(2, 3, 17, 6);
  refused(2, 3, 18, 5);
  EXPECT_TRUE(names().empty());
}

class AtomicFileTest : public test::TempFolderTest {};

TEST_F(AtomicFileTest, ExceptionOfTheWriterPassesAndLeavesNothing) {
  const auto fails = [](const std::string& temporary) {
    std::ofstream(temporary) << "half";
    throw std::runtime_error("stop");
  };
  EXPECT_THROW(writeAtomically(path("a"), fails), std::runtime_error);
  EXPECT_TRUE(names().empty());
}

TEST_F(AtomicFileTest, WriterThatMakesNoFileIsAnError) {
  test::expectError<OutputError>([&] { writeAtomically(path("a"), [](const std::string&) {}); }, path("a"), "file", "");
}

TEST_F(AtomicFileTest, RelativeNameWithoutFolder) {
  const auto before = std::filesystem::current_path();
  std::filesystem::current_path(folder());
  writeTextFile("plain", "text");
  std::filesystem::current_path(before);
  EXPECT_EQ(test::bytesOf(path("plain")), "text");
}

}  // namespace
}  // namespace epcc
