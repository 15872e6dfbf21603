// SPDX-License-Identifier: BSD-3-Clause
// epcc_view --snapshot on a virtual display: the planes are where the camera saw them, in their colours; and what it
// says where nothing can be drawn.
#include <gtest/gtest.h>
#include <png.h>

#include <map>

#include "datasets/files/labelled_frame.h"
#include "eval/pictures/label_colors.h"
#include "eval/view/view_camera.h"
#include "tests/eval/view/need_surfaces.h"
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

/// Pixels that are not the same.
std::size_t differing(const ColorImage& a, const ColorImage& b) {
  std::size_t pixels = 0;
  for (std::size_t i = 0; i < a.data.size(); ++i)
    if (!(a.data[i] == b.data[i])) ++pixels;
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
    return runTool("epcc_view", arguments, folder(), before);
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
    ViewStyle style;
    style.outlines = style.normals = false;
    return viewScene(frameView(frame_), result, {}, style);
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

/// Pixels of the picture with what the sensor has there, seen from the sensor.
class ViewSnapshotOfAHole : public ViewSnapshot {
 protected:
  static constexpr int kLeft = 90, kRight = 130, kTop = 80, kBottom = 115;  // on the back wall, not measured
  void SetUp() override {
    ViewSnapshot::SetUp();
    scene_ = trueScene();  // of the whole room
    camera_ = viewFrom(ViewPlace::Sensor, scene_, 1.0 * kWidth / kHeight);
    for (int row = kTop; row <= kBottom; ++row)
      for (int column = kLeft; column <= kRight; ++column) frame_.depth.at(row, column) = 0.0F;
    writeLabelledFrame(folder(), frame_);
  }
  ColorImage snapshot(const std::string& drawn) const {
    const ToolResult result = run({"room_depth.png", "--draw", drawn, "--keys", "t", "--snapshot", "view.png"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.err, "");
    return readPicture(path("view.png"));
  }
  /// Where the picture has the point that a pixel of the frame saw.
  Eigen::Vector2i placeOf(int row, int column) const {
    Eigen::Vector2d pixel;
    double distance = 0.0;
    const auto& point = scene_.points[static_cast<std::size_t>(320 * row + column)];
    EXPECT_TRUE(projectPoint(camera_, kWidth, kHeight, point.position.cast<double>(), pixel, distance));
    return {static_cast<int>(std::lround(pixel.x())), static_cast<int>(std::lround(pixel.y()))};
  }
  bool isInside(int row, int column, int margin) const {
    return row >= kTop + margin && row <= kBottom - margin && column >= kLeft + margin && column <= kRight - margin;
  }

  ViewScene scene_;
  ViewCamera camera_;
};

TEST_F(ViewSnapshotOfAHole, TheMeshHasThePlanesColoursAndDoesNotCoverIt) {
  EPCC_NEED_DISPLAY();
  EPCC_NEED_SURFACES();
  const ColorImage picture = snapshot("mesh");
  std::map<std::int32_t, std::size_t> seen, right;
  std::size_t in_hole = 0;
  for (int row = 0; row < 240; ++row)
    for (int column = 0; column < 320; ++column) {
      const Eigen::Vector2i place = placeOf(row, column);
      if (place.x() < 0 || place.y() < 0 || place.x() >= kWidth || place.y() >= kHeight) continue;
      const Rgb& pixel = picture.at(place.y(), place.x());
      if (isInside(row, column, 2)) {
        ++in_hole;
        EXPECT_TRUE(pixel == kBackgroundColor) << "the hole is covered at " << row << ' ' << column;
      }
      if (isInside(row, column, -2)) continue;
      const std::int32_t label = scene_.points[static_cast<std::size_t>(320 * row + column)].label;
      ++seen[label];
      if (pixel == labelColor(label)) ++right[label];
    }
  EXPECT_GT(in_hole, 1000U);
  ASSERT_EQ(seen.size(), 3U);
  for (const auto& [label, number] : seen)
    EXPECT_GT(static_cast<double>(right[label]), 0.95 * static_cast<double>(number)) << label;
  EXPECT_EQ(count(picture, kUnlabelledColor), 0U) << "no points";
}

TEST_F(ViewSnapshotOfAHole, PolygonsAreLinesRoundItAndRoundThePlanes) {
  EPCC_NEED_DISPLAY();
  EPCC_NEED_SURFACES();
  const ColorImage picture = snapshot("polygons");
  // The distance from each pixel of the hole's rim to the next that is drawn.
  const auto is_drawn_near = [&](int row, int column) {
    const Eigen::Vector2i place = placeOf(row, column);
    for (int y = place.y() - 4; y <= place.y() + 4; ++y)
      for (int x = place.x() - 4; x <= place.x() + 4; ++x)
        if (!(picture.at(y, x) == kBackgroundColor)) return true;
    return false;
  };
  for (int row = kTop; row <= kBottom; ++row) EXPECT_TRUE(is_drawn_near(row, kLeft) && is_drawn_near(row, kRight));
  for (int column = kLeft; column <= kRight; ++column)
    EXPECT_TRUE(is_drawn_near(kTop, column) && is_drawn_near(kBottom, column));
  for (const int inset : {8, 14}) {
    EXPECT_FALSE(is_drawn_near(kTop + inset, kLeft + inset)) << "within it";
    EXPECT_FALSE(is_drawn_near(kTop + inset, kLeft - inset)) << "beside it";
  }
  EXPECT_LT(count(picture, labelColor(1)), 20U) << "no points, no mesh";
}

TEST_F(ViewSnapshotOfAHole, KeysDrawTheSameAsTheOption) {
  EPCC_NEED_DISPLAY();
  EPCC_NEED_SURFACES();
  const auto pressed = [&](const std::string& keys) {
    EXPECT_EQ(run({"room_depth.png", "--keys", keys, "--snapshot", "view.png"}).exit_code, 0);
    return readPicture(path("view.png"));
  };
  EXPECT_EQ(differing(pressed("t,f,a"), snapshot("mesh,polygons")), 0U);
  EXPECT_EQ(differing(pressed("t,f,f,o"), snapshot("points,mesh,normals")), 0U);
  const ColorImage polygons = pressed("t"), contours = pressed("t,c");
  EXPECT_EQ(differing(polygons, snapshot("points,polygons,normals")), 0U);
  EXPECT_EQ(differing(contours, snapshot("points,contours,normals")), 0U);
  EXPECT_GT(differing(polygons, contours), 100U);
}

TEST_F(ViewSnapshot, ABuildWithoutSurfacesSaysSoInOneLine) {
  EPCC_NEED_NO_SURFACES();
  EPCC_NEED_DISPLAY();
  const ToolResult result = run({"room_depth.png", "--keys", "f,c,v", "--snapshot", "view.png"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.err, "epcc_view: no polygons, no mesh: " + surfacesMissing() + "\n");
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

TEST_F(ViewSnapshot, TheKeyThatQuitsOpensNoWindow) {
  const ToolResult result = run({"room_depth.png", "--keys", "n,q"}, display_.command() + "timeout 30 ");
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out + result.err, "");
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
