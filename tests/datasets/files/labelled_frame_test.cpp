// SPDX-License-Identifier: BSD-3-Clause
// Labelled frames: round trip, the list of a folder, and files that do not fit together.
#include "datasets/files/labelled_frame.h"

#include <gtest/gtest.h>

#include <cctype>
#include <cmath>
#include <limits>

#include "datasets/files/png_io.h"
#include "tests/support/expect_errors.h"

namespace epcc {
namespace {

class LabelledFrameTest : public test::TempFolderTest {
 protected:
  static LabelledFrame frame(const std::string& name = "room") {
    LabelledFrame result;
    result.name = name;
    result.camera.camera = {7, 5, 6.0, 6.5, 3.0, 2.0};
    result.camera.depth_scale = 0.0002;
    result.camera.extra = {{"source", "made up"}};
    result.depth = DepthImage(7, 5);
    result.labels = LabelImage(7, 5);
    for (std::size_t i = 0; i < result.depth.data.size(); ++i) {
      result.depth.data[i] = static_cast<float>(0.0002 * static_cast<double>(1 + 1900 * i));
      result.labels.data[i] = static_cast<std::uint16_t>(i % 3);
    }
    result.depth.at(4, 6) = 0.0f;
    result.labels.at(0, 0) = kIgnoreLabel;
    return result;
  }
  void expectRefused(const std::string& ending, const std::string& field, const std::string& part) const {
    test::expectInputError([&] { readLabelledFrame(folder(), "room"); }, path("room" + ending), field, part);
  }
};

TEST_F(LabelledFrameTest, RoundTrip) {
  const LabelledFrame written = frame();
  writeLabelledFrame(folder(), written);
  const LabelledFrame read = readLabelledFrame(folder(), "room");
  EXPECT_EQ(read.name, "room");
  EXPECT_EQ(read.camera.camera.fy, 6.5);
  EXPECT_EQ(read.camera.extra, written.camera.extra);
  EXPECT_EQ(read.labels.data, written.labels.data);
  ASSERT_EQ(read.depth.data.size(), written.depth.data.size());
  EXPECT_EQ(read.depth.width, 7);
  for (std::size_t i = 0; i < read.depth.data.size(); ++i) EXPECT_FLOAT_EQ(read.depth.data[i], written.depth.data[i]);
  EXPECT_EQ(names(), (std::vector<std::string>{"room.json", "room_depth.png", "room_labels.png"}));
}

TEST_F(LabelledFrameTest, SecondRoundTripChangesNoBit) {
  writeLabelledFrame(folder(), frame());
  const LabelledFrame once = readLabelledFrame(folder(), "room");
  writeLabelledFrame(folder(), once);
  EXPECT_EQ(readLabelledFrame(folder(), "room").depth.data, once.depth.data);
}

TEST_F(LabelledFrameTest, WithoutLabelsIsFine) {
  LabelledFrame unlabelled = frame();
  unlabelled.labels = LabelImage();
  writeLabelledFrame(folder(), unlabelled);
  const LabelledFrame read = readLabelledFrame(folder(), "room");
  EXPECT_TRUE(read.labels.empty());
  EXPECT_EQ(read.depth.width, 7);
}

TEST_F(LabelledFrameTest, DepthsThatDoNotFitBecomeInvalid) {
  LabelledFrame odd = frame();
  const float values[] = {std::numeric_limits<float>::quiet_NaN(),
                          std::numeric_limits<float>::infinity(),
                          -1.0f,
                          1e-6f,
                          13.2f,
                          65535 * 0.0002f,
                          -std::numeric_limits<float>::infinity()};
  std::copy(std::begin(values), std::end(values), odd.depth.data.begin());
  writeLabelledFrame(folder(), odd);
  const auto raw = readGray16(path("room_depth.png"));
  EXPECT_EQ(std::vector<std::uint16_t>(raw.data.begin(), raw.data.begin() + 7),
            (std::vector<std::uint16_t>{0, 0, 0, 0, 0, 65535, 0}));
}

TEST_F(LabelledFrameTest, DepthIsRoundedToTheNearestUnit) {
  LabelledFrame fine = frame();
  fine.depth.data[0] = 0.0002f * 10.4f;
  fine.depth.data[1] = 0.0002f * 10.6f;
  writeLabelledFrame(folder(), fine);
  const auto raw = readGray16(path("room_depth.png"));
  EXPECT_EQ(raw.data[0], 10);
  EXPECT_EQ(raw.data[1], 11);
}

TEST_F(LabelledFrameTest, ListIsSortedAndHoldsFramesOnly) {
  for (const char* name : {"b_depth.png", "a_depth.png", "a.json", "c_labels.png", "_depth.png", "d_depth.pngx"})
    write(name, "x");
  EXPECT_EQ(listLabelledFrames(folder()), (std::vector<std::string>{"a", "b"}));
}

TEST_F(LabelledFrameTest, ListIsInTheOrderOfTheNumbersInTheNames) {
  for (const char* name : {"f10_depth.png", "f2_depth.png", "f1_depth.png", "f010_depth.png"}) write(name, "x");
  EXPECT_EQ(listLabelledFrames(folder()), (std::vector<std::string>{"f1", "f2", "f010", "f10"}));
}

TEST_F(LabelledFrameTest, ExtensionsMayBeInCapitals) {
  writeLabelledFrame(folder(), frame());
  for (const char* ending : {"_depth.png", "_labels.png", ".json"}) {
    std::string capitals = ending;
    for (std::size_t i = capitals.find('.'); i < capitals.size(); ++i)
      capitals[i] = static_cast<char>(std::toupper(static_cast<unsigned char>(capitals[i])));
    std::filesystem::rename(path(std::string("room") + ending), path("room" + capitals));
  }
  EXPECT_EQ(names(), (std::vector<std::string>{"room.JSON", "room_depth.PNG", "room_labels.PNG"}));
  EXPECT_EQ(listLabelledFrames(folder()), std::vector<std::string>{"room"});
  const LabelledFrame read = readLabelledFrame(folder(), "room");
  EXPECT_EQ(read.depth.width, 7);
  EXPECT_EQ(read.labels.data, frame().labels.data);
}

TEST_F(LabelledFrameTest, ListOfAnEmptyFolderIsEmpty) {
  EXPECT_TRUE(listLabelledFrames(folder()).empty());
}

TEST_F(LabelledFrameTest, ListOfAMissingFolder) {
  test::expectInputError([&] { listLabelledFrames(path("no")); }, path("no"), "folder", "");
}
TEST_F(LabelledFrameTest, ListOfAFile) {
  const std::string file = write("file", "x");
  test::expectInputError([&] { listLabelledFrames(file); }, file, "folder", "");
}

/// Two rows of two points, seen by a scanner with x forward; the third was not measured.
const char kScan[] =
    "VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 2\nHEIGHT 2\n"
    "VIEWPOINT 0 0 0 1 0 0 0\nPOINTS 4\nDATA ascii\n1 2 2\n3 0 4\nnan nan nan\n0 4 3\n";

TEST_F(LabelledFrameTest, ACloudWithAJsonIsAScan) {
  write("street.pcd", kScan);
  write("street.json",
        R"({"cloud": "street.pcd", "width": 2, "height": 2, "fx": 0, "depth_scale": 0, "noise": "0.02,0,1"})");
  LabelImage labels(2, 2);
  labels.data = {1, 2, 0, kIgnoreLabel};
  writeGray16(path("street_labels.png"), labels);
  EXPECT_EQ(listLabelledFrames(folder()), std::vector<std::string>{"street"});
  EXPECT_EQ(labelledFrameFile(folder(), "street"), path("street.pcd"));
  const LabelledFrame read = readLabelledFrame(folder(), "street");
  EXPECT_EQ(read.name, "street");
  EXPECT_EQ(read.labels.data, labels.data);
  ASSERT_EQ(read.scan.size(), 12U);
  EXPECT_EQ(read.scan[5], 4.0F);
  EXPECT_EQ(read.camera.noise, "0.02,0,1");
  EXPECT_EQ(read.camera.extra.at("cloud"), "street.pcd");
  EXPECT_EQ(read.camera.camera.width, 0) << "there is no camera";
  EXPECT_EQ(frameView(read).width(), 2);

  writeGray16(path("street_labels.png"), LabelImage(2, 3));
  test::expectInputError([&] { readLabelledFrame(folder(), "street"); }, path("street_labels.png"), "size",
                         "2x3, but the cloud has 2x2");
  std::filesystem::remove(path("street_labels.png"));
  EXPECT_TRUE(readLabelledFrame(folder(), "street").labels.empty());
}

TEST_F(LabelledFrameTest, ListHoldsImagesAndScansButNoBareCloud) {
  for (const char* name : {"f2_depth.png", "f1.pcd", "f1.json", "bare.pcd", "f3_depth.png", "f3.pcd", "f3.json"})
    write(name, "x");
  EXPECT_EQ(listLabelledFrames(folder()), (std::vector<std::string>{"f1", "f2", "f3"}));
  EXPECT_EQ(labelledFrameFile(folder(), "f3"), path("f3_depth.png"));
}

TEST_F(LabelledFrameTest, MissingJson) {
  writeLabelledFrame(folder(), frame());
  std::filesystem::remove(path("room.json"));
  expectRefused(".json", "file", "does not exist");
}
TEST_F(LabelledFrameTest, MissingDepth) {
  writeLabelledFrame(folder(), frame());
  std::filesystem::remove(path("room_depth.png"));
  expectRefused("_depth.png", "file", "does not exist");
}
TEST_F(LabelledFrameTest, DepthOfAnotherSize) {
  writeLabelledFrame(folder(), frame());
  writeGray16(path("room_depth.png"), LabelImage(5, 7));
  expectRefused("_depth.png", "size", "5x7, but the camera file says 7x5");
}
TEST_F(LabelledFrameTest, LabelsOfAnotherSize) {
  writeLabelledFrame(folder(), frame());
  writeGray16(path("room_labels.png"), LabelImage(7, 6));
  expectRefused("_labels.png", "size", "7x6, but the camera file says 7x5");
}
TEST_F(LabelledFrameTest, EmptyLabelsFile) {
  writeLabelledFrame(folder(), frame());
  write("room_labels.png", "");
  expectRefused("_labels.png", "file", "is empty");
}
TEST_F(LabelledFrameTest, LabelsAreAFolder) {
  writeLabelledFrame(folder(), frame());
  std::filesystem::remove(path("room_labels.png"));
  std::filesystem::create_directory(path("room_labels.png"));
  expectRefused("_labels.png", "file", "is a folder");
}
TEST_F(LabelledFrameTest, EightBitLabels) {
  writeLabelledFrame(folder(), frame());
  writeRgb(path("room_labels.png"), ColorImage(7, 5));
  expectRefused("_labels.png", "color type", "greyscale");
}

TEST_F(LabelledFrameTest, FramesWhoseSizesDisagreeAreNotWritten) {
  LabelledFrame wrong = frame();
  wrong.labels = LabelImage(7, 4);
  test::expectError<OutputError>([&] { writeLabelledFrame(folder(), wrong); }, path("room_labels.png"), "size",
                                 "camera");
  wrong = frame();
  wrong.depth = DepthImage(6, 5);
  test::expectError<OutputError>([&] { writeLabelledFrame(folder(), wrong); }, path("room_depth.png"), "size",
                                 "camera");
  EXPECT_TRUE(names().empty());
}

}  // namespace
}  // namespace epcc
