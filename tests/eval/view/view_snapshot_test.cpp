// SPDX-License-Identifier: BSD-3-Clause
// epcc_view --snapshot on a virtual display: the planes are where the camera saw them, in their colours; and what it
// says where nothing can be drawn.
#include <gtest/gtest.h>
#include <png.h>

#include <map>

#include "datasets/files/labelled_frame.h"
#include "eval/pictures/label_colors.h"
#include "eval/view/view_camera.h"
#include "tests/eval/view/virtual_display.h"
#include "tests/support/real_frames.h"
#include "tests/support/rendered_room.h"
#include "tests/support/run_tool.h"

namespace epcc::test {
namespace {

constexpr int kWidth = 640, kHeight = 400;

bool operator==(const Rgb& a, const Rgb& b) {
  return a.r == b.r && a.g == b.g && a.b == b.b;
}

ColorImage readPicture(const std::string& path) {
  png_image png = {};
  png.version = PNG_IMAGE_VERSION;
  EXPECT_NE(png_image_begin_read_from_file(&png, path.c_str()), 0) << path;
  png.format = PNG_FORMAT_RGB;
  ColorImage image(static_cast<int>(png.width), static_cast<int>(png.height));
  EXPECT_NE(png_image_finish_read(&png, nullptr, image.data.data(), 0, nullptr), 0) << path;
  return image;
}

std::size_t count(const ColorImage& image, const Rgb& color) {
  std::size_t pixels = 0;
  for (const Rgb& pixel : image.data)
    if (pixel == color) ++pixels;
  return pixels;
}

class ViewSnapshot : public TempFolderTest {
 protected:
  void SetUp() override {
    TempFolderTest::SetUp();
    RenderedRoom room = renderRoom(cornerPlanes(), testCamera(320, 240));
    addNoise(room, SensorModel::axial(0.0005, 0.0005), 1);
    frame_.name = "room";
    frame_.camera.camera = room.camera;
    frame_.camera.depth_scale = 0.0001;
    frame_.camera.noise = "0.0005,0.0005,1";
    frame_.depth = DepthImage(320, 240);
    frame_.depth.data = room.depth;
    truth_ = room.labels;
    writeLabelledFrame(folder(), frame_);
  }
  ToolResult run(std::vector<std::string> arguments, const std::string& before) const {
    arguments.insert(arguments.end(), {"--size", "640x400"});
    return runTool(EPCC_VIEW, arguments, folder(), before);
  }
  ToolResult run(const std::vector<std::string>& arguments) const { return run(arguments, display_.command()); }
  void expectFailure(const std::vector<std::string>& arguments, int code, const std::string& words,
                     const std::string& before) const {
    test::expectFailure(run(arguments, before), "epcc_view", code, words);
  }

  /// The scene as the truth has it: labels largest first, as the program numbers planes.
  ViewScene trueScene() const {
    std::map<std::int32_t, std::size_t> pixels;
    for (const std::int32_t label : truth_) ++pixels[label];
    std::vector<std::pair<std::size_t, std::int32_t>> order;
    for (const auto& [label, number] : pixels) order.emplace_back(number, label);
    std::sort(order.rbegin(), order.rend());
    PlaneSegmentation result;
    result.width = 320;
    result.height = 240;
    for (const std::int32_t label : truth_)
      for (std::size_t k = 0; k < order.size(); ++k)
        if (order[k].second == label) result.labels.push_back(static_cast<std::int32_t>(k) + 1);
    result.planes.resize(order.size());
    return viewScene(frameView(frame_), result, {false, false, true, 0});
  }

  VirtualDisplay display_;
  LabelledFrame frame_;
  std::vector<std::int32_t> truth_;
};

#define EPCC_NEED_DISPLAY() \
  if (!display_.exists()) GTEST_SKIP() << "Xvfb not found (Debian package xvfb)"

TEST_F(ViewSnapshot, PlanesAreWhereTheyWereSeenInTheirColours) {
  EPCC_NEED_DISPLAY();
  const ToolResult result = run({"room_depth.png", "--keys", "t,o,a", "--snapshot", "view.png"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out, "");
  const ColorImage picture = readPicture(path("view.png"));
  ASSERT_EQ(picture.width, kWidth);
  ASSERT_EQ(picture.height, kHeight);

  const ViewScene scene = trueScene();
  const ViewCamera camera = viewFrom(ViewPlace::Sensor, scene, 1.0 * kWidth / kHeight);
  std::map<std::int32_t, std::size_t> seen, right;
  for (const ViewPoint& point : scene.points) {
    Eigen::Vector2d pixel;
    double distance = 0.0;
    if (!projectPoint(camera, kWidth, kHeight, point.position.cast<double>(), pixel, distance)) continue;
    const int column = static_cast<int>(std::lround(pixel.x())), row = static_cast<int>(std::lround(pixel.y()));
    if (column < 0 || row < 0 || column >= kWidth || row >= kHeight) continue;
    ++seen[point.label];
    if (picture.at(row, column) == labelColor(point.label)) ++right[point.label];
  }
  ASSERT_EQ(seen.size(), 3U);
  for (const auto& [label, number] : seen)
    EXPECT_GT(static_cast<double>(right[label]), 0.97 * static_cast<double>(number)) << label;

  // The image's 4:3 in 8:5: beside it is background.
  const auto pixels = static_cast<double>(picture.data.size());
  EXPECT_NEAR(static_cast<double>(count(picture, kBackgroundColor)) / pixels, 0.25, 0.12);
  for (const int column : {0, kWidth - 1})
    for (const int row : {0, kHeight / 2, kHeight - 1})
      EXPECT_TRUE(picture.at(row, column) == kBackgroundColor) << column << ' ' << row;
}

TEST_F(ViewSnapshot, TextsOutlinesNormalsAndSelectionAreDrawn) {
  EPCC_NEED_DISPLAY();
  const auto snapshot = [&](const std::string& keys) {
    const ToolResult result = run({"room_depth.png", "--keys", keys, "--snapshot", "view.png"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return readPicture(path("view.png"));
  };
  const auto differing = [](const ColorImage& a, const ColorImage& b) {
    std::size_t pixels = 0;
    for (std::size_t i = 0; i < a.data.size(); ++i)
      if (!(a.data[i] == b.data[i])) ++pixels;
    return pixels;
  };
  const ColorImage bare = snapshot("t,o,a");
  EXPECT_EQ(differing(bare, snapshot("t,o,a")), 0U) << "the same each time";
  EXPECT_GT(differing(bare, snapshot("t,a")), 500U) << "outlines";
  EXPECT_GT(differing(bare, snapshot("t,o")), 200U) << "normals";
  EXPECT_GT(differing(bare, snapshot("o,a")), 2000U) << "texts";
  const ColorImage selected = snapshot("t,a,Tab");
  EXPECT_GT(count(selected, labelColor(1)), count(bare, labelColor(1)) / 2);
  EXPECT_EQ(count(selected, labelColor(2)), 0U) << "dimmed";
  EXPECT_GT(count(selected, Rgb{255, 255, 255}), 300U) << "its outline";
}

TEST_F(ViewSnapshot, ARealFrameOfACameraAndOfAScanner) {
  EPCC_NEED_DISPLAY();
  EPCC_NEED_REAL_FRAMES("realsense");
  EPCC_NEED_REAL_FRAMES("sensors");
  for (const std::string file : {"realsense/felix_000000_depth.png", "sensors/ouster_os1_128_street.pcd"}) {
    const ToolResult result = run({realFolder(file), "--keys", "t", "--snapshot", "view.png"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const ColorImage picture = readPicture(path("view.png"));
    const auto pixels = picture.data.size();
    EXPECT_GT(count(picture, kBackgroundColor), pixels / 20) << file;
    EXPECT_LT(count(picture, kBackgroundColor), pixels * 9 / 10) << file;
    EXPECT_GT(count(picture, kUnlabelledColor), pixels / 200) << file;
    for (const std::int32_t label : {1, 2, 3}) EXPECT_GT(count(picture, labelColor(label)), pixels / 500) << file;
  }
}

TEST_F(ViewSnapshot, WithoutADisplayItEndsInOneLine) {
  const std::vector<std::string> arguments = {"room_depth.png", "--snapshot", "view.png"};
  expectFailure(arguments, 3, "display: DISPLAY is not set; ", "env -u DISPLAY ");
  expectFailure(arguments, 3, "display: :7654 cannot be opened; ", "env DISPLAY=:7654 ");
  expectFailure({"room_depth.png"}, 3, "display: DISPLAY is not set; ", "env -u DISPLAY ");
  EXPECT_FALSE(exists("view.png"));
}

TEST_F(ViewSnapshot, WhatCannotBeUsedOrWrittenIsTold) {
  EPCC_NEED_DISPLAY();
  expectFailure({"no.pcd", "--snapshot", "view.png"}, 3, "no.pcd: file: does not exist", display_.command());
  expectFailure({"room_depth.png", "--snapshot", "no_folder/view.png"}, 4, "no_folder/view.png", display_.command());
  EXPECT_FALSE(exists("view.png"));
  EXPECT_EQ(names().size(), 2U) << "nothing is left";
}

TEST_F(ViewSnapshot, NoInputIsOverwritten) {
  const std::string before = read("room_depth.png");
  for (const char* input : {"room_depth.png", "room.json"})
    expectFailure({".", "--snapshot", input}, 2, "would overwrite an input", "env -u DISPLAY ");
  EXPECT_EQ(read("room_depth.png"), before);
}

}  // namespace
}  // namespace epcc::test
