// SPDX-License-Identifier: BSD-3-Clause
// The limits of docs/reference/limits.md at their boundaries: the last that is allowed passes, the first that is not is
// refused in one line. Where what passes would be large the file ends behind its header, and that is what is told.
#include <gtest/gtest.h>

#include <cstdint>
#include <string>

#include "datasets/files/camera_json.h"
#include "datasets/files/label_image.h"
#include "datasets/files/laser_log.h"
#include "datasets/files/npy_labels.h"
#include "datasets/files/pcd_header.h"
#include "datasets/files/png_io.h"
#include "datasets/files/sun_raster.h"
#include "datasets/files/text_lines.h"
#include "datasets/files/trajectory_file.h"
#include "tests/datasets/files/npy_bytes.h"
#include "tests/datasets/files/pcd_text.h"
#include "tests/datasets/files/png_bytes.h"
#include "tests/support/expect_errors.h"

namespace epcc {
namespace {

using test::expectInputError;

class FileLimits : public test::TempFolderTest {
 protected:
  std::string png(std::uint32_t width, std::uint32_t height) const {
    test::PngRecipe recipe = test::grayRecipe();
    recipe.width = width;
    recipe.height = height;
    return write("a.png", test::pngBytes(recipe));
  }
  std::string pcd(int width, int height) const {
    const std::string points = std::to_string(static_cast<long>(width) * height);
    return write(
        "a.pcd",
        test::binaryPcd({{"WIDTH", std::to_string(width)}, {"HEIGHT", std::to_string(height)}, {"POINTS", points}}));
  }
  std::string camera(const std::string& width, const std::string& height, const std::string& scale = "0.001",
                     const std::string& more = "") const {
    return write("a.json", "{\"width\":" + width + ",\"height\":" + height + ",\"depth_scale\":" + scale +
                               ",\"fx\":500,\"fy\":500,\"cx\":0,\"cy\":0" + more + "}");
  }
};

TEST_F(FileLimits, SidesOfAnImage) {
  const std::string wide = path("wide.png"), high = path("high.png");
  writeGray16(wide, Image<std::uint16_t>(kMaxImageSide, 1));
  writeGray16(high, Image<std::uint16_t>(1, kMaxImageSide));
  EXPECT_EQ(readGray16(wide).width, 16384);
  EXPECT_EQ(readGray16(high).height, 16384);
  for (const auto& [width, height] : {std::pair{16385u, 1u}, {1u, 16385u}}) {
    const std::string file = png(width, height);
    expectInputError([&] { readGray16(file); }, file, "PNG header", "");
  }
}

TEST_F(FileLimits, PixelsOfAnImage) {
  const std::string most = png(16000, 4000);
  expectInputError([&] { readGray16(most); }, most, "size", "the file is too short for so many pixels");
  const std::string more = png(16000, 4001);
  expectInputError([&] { readGray16(more); }, more, "size", "more than 64000000 pixels");
}

TEST_F(FileLimits, PointsOfACloud) {
  for (const auto& [width, height] : {std::pair{16384, 2}, {1, 16384}, {16000, 4000}}) {
    const std::string file = pcd(width, height);
    expectInputError([&] { readPcdHeader(file); }, file, "DATA", "is shorter");
  }
  const auto refused = [](const std::string& file, const std::string& field, const std::string& part) {
    expectInputError([&] { readPcdHeader(file); }, file, field, part);
  };
  refused(pcd(16385, 2), "WIDTH", "is more than 16384");
  refused(pcd(1, 16385), "HEIGHT", "is not in 1..16384");
  refused(pcd(16000, 4001), "WIDTH", "times HEIGHT is more than 64000000 points");
}

TEST_F(FileLimits, FieldsOfACloud) {
  const auto cloud = [&](int fields, int bytes) {
    std::string names = "x y z", sizes = "4 4 4", types = "F F F", counts = "1 1 1";
    for (int i = 3; i < fields; ++i) {
      names += " f" + std::to_string(i);
      sizes += " 1";
      types += " U";
      counts += " " + std::to_string(i + 1 < fields ? 1 : bytes - 12 - (fields - 4));
    }
    return write("a.pcd", test::binaryPcd({{"FIELDS", names}, {"SIZE", sizes}, {"TYPE", types}, {"COUNT", counts}}));
  };
  for (const auto& [fields, bytes] : {std::pair{256, 300}, {4, 4096}}) {
    const std::string file = cloud(fields, bytes);
    expectInputError([&] { readPcdHeader(file); }, file, "DATA", "is shorter");
  }
  const std::string many = cloud(257, 300);
  expectInputError([&] { readPcdHeader(many); }, many, "FIELDS", "more than 256");
  const std::string large = cloud(4, 4097);
  expectInputError([&] { readPcdHeader(large); }, large, "COUNT", "points of more than 4096 bytes");
}

TEST_F(FileLimits, HeaderOfACloud) {
  const std::string good = test::asciiPcd();
  const std::size_t header = test::pcdHeader().size();
  const auto with_comment = [&](std::size_t bytes) {
    return write("a.pcd", "#" + std::string(bytes - header - 2, '-') + "\n" + good);
  };
  EXPECT_EQ(readPcdHeader(with_comment(64 * 1024)).width, 3);
  const std::string longer = with_comment(64 * 1024 + 1);
  expectInputError([&] { readPcdHeader(longer); }, longer, "DATA", "is missing");
}

TEST_F(FileLimits, SizeOfACamera) {
  EXPECT_EQ(readCameraJson(camera("16384", "1")).camera.width, 16384);
  EXPECT_EQ(readCameraJson(camera("16000", "4000")).camera.height, 4000);
  EXPECT_EQ(readCameraJson(camera("4", "3", "1000")).depth_scale, 1000.0);
  const auto refused = [](const std::string& file, const std::string& field, const std::string& part) {
    expectInputError([&] { readCameraJson(file); }, file, field, part);
  };
  refused(camera("16385", "1"), "width", "must be a whole number from 1 to 16384");
  refused(camera("16000", "4001"), "width", "times height is more than 64000000 pixels");
  refused(camera("4", "3", "1000.01"), "depth_scale", "is more than 1000 m a unit");
}

TEST_F(FileLimits, LengthAndNestingOfJson) {
  const auto of_length = [&](std::size_t bytes) {
    const std::string text = "{\"a\": 1}";
    return write("a.json", text + std::string(bytes - text.size(), ' '));
  };
  EXPECT_EQ(readJsonObject(of_length(16u << 20)).size(), 1U);
  const std::string longer = of_length((16u << 20) + 1);
  expectInputError([&] { readJsonObject(longer); }, longer, "file", "is larger than 16 MiB");

  const auto nested = [&](std::size_t depth) {
    return write("b.json", "{\"a\":" + std::string(depth - 1, '[') + std::string(depth - 1, ']') + "}");
  };
  EXPECT_EQ(readJsonObject(nested(100)).size(), 1U);
  const std::string deeper = nested(102);
  expectInputError([&] { readJsonObject(deeper); }, deeper, "JSON", "is nested too deeply");
}

TEST_F(FileLimits, HeaderOfAnNpyFile) {
  const std::string dictionary = test::npyHeader("|u1", "(1, 2)");
  const auto with_header = [&](std::size_t bytes) {
    std::string start("\x93NUMPY\x02\x00", 8);
    for (int i = 0; i < 4; ++i) start += static_cast<char>((bytes >> (8 * i)) & 0xff);
    return write("a.npy", start + dictionary + std::string(bytes - dictionary.size(), ' ') + "\x01\x02");
  };
  EXPECT_EQ(readNpyLabels(with_header(65535), 2, 1).data, (std::vector<std::uint16_t>{1, 2}));
  const std::string longer = with_header(65536);
  expectInputError([&] { readNpyLabels(longer, 2, 1); }, longer, "header", "is cut short or too long");
}

TEST_F(FileLimits, LengthOfALine) {
  const auto with_comment = [&](std::size_t bytes) {
    return write("poses.txt", "#" + std::string(bytes - 1, '-') + "\n1 0 0 0 0 0 0 1\n");
  };
  EXPECT_EQ(readTrajectory(with_comment(kMaxTextLine)).size(), 1U);
  const std::string longer = with_comment(kMaxTextLine + 1);
  expectInputError([&] { readTrajectory(longer); }, longer, "line 1", "is longer than 16 MiB");
}

TEST_F(FileLimits, PosesAndScans) {
  EXPECT_NO_THROW(checkPoseCount("poses.txt", 7, 10000000));
  expectInputError([] { checkPoseCount("poses.txt", 7, 10000001); }, "poses.txt", "line 7", "more poses than 10000000");
  EXPECT_NO_THROW(checkLogSize("a.log", 7, 10000000, 200000000));
  expectInputError([] { checkLogSize("a.log", 7, 10000001, 0); }, "a.log", "line 7",
                   "more than 10000000 scans: split the log");
  expectInputError([] { checkLogSize("a.log", 7, 0, 200000001); }, "a.log", "line 7",
                   "more than 200000000 beams: split the log");
}

TEST_F(FileLimits, PlanesOfALabelImage) {
  PlaneSegmentation segmentation;
  segmentation.width = 2;
  segmentation.height = 1;
  segmentation.labels = {65534, 0};
  segmentation.planes.resize(65534);
  const std::string file = path("labels.png");
  writeLabelImage(file, segmentation);
  EXPECT_EQ(readGray16(file).data, (std::vector<std::uint16_t>{65534, 0}));
  segmentation.planes.resize(65535);
  test::expectError<OutputError>([&] { writeLabelImage(file, segmentation); }, file, "labels",
                                 "more planes than a 16-bit image can hold");
}

}  // namespace
}  // namespace epcc
