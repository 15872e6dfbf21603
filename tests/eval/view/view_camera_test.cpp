// SPDX-License-Identifier: BSD-3-Clause
// Views hold the points, the sensor's view looks like its image, and the point under the mouse is the nearest one.
#include "eval/view/view_camera.h"

#include <gtest/gtest.h>

#include "epcc_segmentation/plane_extractor.h"
#include "tests/support/tiny_frames.h"

namespace epcc {
namespace {

constexpr int kWidth = 1280, kHeight = 800;
constexpr double kAspect = 1.6;

ViewScene roomScene() {
  const LabelledFrame frame = test::tinyFrame("room", 1);
  PlaneSegmentation result;
  PlaneExtractor extractor(Parameters(), SensorModel::axial(0.0005, 0.0005));
  EXPECT_TRUE(extractor.extract(frameView(frame), result));
  return viewScene(frameView(frame), result, {}, ViewStyle());
}

double shareInPicture(const ViewScene& scene, const ViewCamera& camera) {
  std::size_t inside = 0;
  for (const ViewPoint& point : scene.points) {
    Eigen::Vector2d pixel;
    double distance = 0.0;
    if (!projectPoint(camera, kWidth, kHeight, point.position.cast<double>(), pixel, distance)) continue;
    if (pixel.x() >= 0 && pixel.y() >= 0 && pixel.x() < kWidth && pixel.y() < kHeight) ++inside;
  }
  return static_cast<double>(inside) / static_cast<double>(scene.points.size());
}

TEST(ViewCamera, EveryPlaceHoldsThePoints) {
  const ViewScene scene = roomScene();
  for (const ViewPlace place : {ViewPlace::Sensor, ViewPlace::Slanted, ViewPlace::Top})
    EXPECT_GT(shareInPicture(scene, viewFrom(place, scene, kAspect)), 0.97) << static_cast<int>(place);
}

TEST(ViewCamera, TheSensorsViewFillsThePicture) {
  const ViewScene scene = roomScene();
  double lowest = 0.0, highest = kHeight;
  for (const ViewPoint& point : scene.points) {
    Eigen::Vector2d pixel;
    double distance = 0.0;
    ASSERT_TRUE(projectPoint(viewFrom(ViewPlace::Sensor, scene, kAspect), kWidth, kHeight,
                             point.position.cast<double>(), pixel, distance));
    lowest = std::max(lowest, pixel.y());
    highest = std::min(highest, pixel.y());
  }
  EXPECT_GT(lowest - highest, 0.8 * kHeight);
}

TEST(ViewCamera, TheSensorsViewIsAsTheImage) {
  const ViewScene scene = roomScene();
  const ViewCamera camera = viewFrom(ViewPlace::Sensor, scene, kAspect);
  const auto pixelOf = [&](std::size_t index) {
    Eigen::Vector2d pixel;
    double distance = 0.0;
    EXPECT_TRUE(projectPoint(camera, kWidth, kHeight, scene.points[index].position.cast<double>(), pixel, distance));
    return pixel;
  };
  const Eigen::Vector2d upper_left = pixelOf(0), upper_right = pixelOf(79), lower_left = pixelOf(80 * 59);
  EXPECT_GT(upper_right.x() - upper_left.x(), 300.0);
  EXPECT_GT(lower_left.y() - upper_left.y(), 300.0);
}

TEST(ViewCamera, ScannersAreSeenFromOutside) {
  ViewScene scene = roomScene();
  EXPECT_EQ(firstPlace(scene), ViewPlace::Sensor);
  scene.sensor.is_scanner = true;
  EXPECT_EQ(firstPlace(scene), ViewPlace::Slanted);
}

TEST(ViewCamera, AnEmptySceneHasAView) {
  ViewScene scene;
  scene.sensor = {{0, 0, 0}, {0, 0, 1}, {0, -1, 0}, false};
  const ViewCamera camera = viewFrom(ViewPlace::Slanted, scene, kAspect);
  EXPECT_GT((camera.target - camera.position).norm(), 0.5);
  EXPECT_EQ(pointAt(scene, camera, kWidth, kHeight, 640, 400), -1);
}

TEST(ViewCamera, OnePointHasAView) {
  ViewScene scene;
  scene.sensor = {{0, 0, 0}, {0, 0, 1}, {0, -1, 0}, false};
  scene.points.push_back({{0.0F, 0.0F, 2.0F}, {}, 1});
  for (const ViewPlace place : {ViewPlace::Sensor, ViewPlace::Slanted, ViewPlace::Top}) {
    const ViewCamera camera = viewFrom(place, scene, kAspect);
    EXPECT_GE(camera.angle, 0.0);
    EXPECT_EQ(pointAt(scene, camera, kWidth, kHeight, 640, 400), 0) << static_cast<int>(place);
  }
}

TEST(ViewCamera, ThePickedPointIsTheNearestUnderTheMouse) {
  ViewScene scene;
  scene.points.push_back({{0.0F, 0.0F, 5.0F}, {}, 1});
  scene.points.push_back({{0.0F, 0.0F, 2.0F}, {}, 2});
  scene.points.push_back({{0.0F, 0.0F, -2.0F}, {}, 3});  // behind the camera
  scene.points.push_back({{1.0F, 0.0F, 2.0F}, {}, 4});
  const ViewCamera camera;  // in the origin, along z
  const auto labelAt = [&](double x, double y) {
    const int point = pointAt(scene, camera, kWidth, kHeight, x, y);
    return point < 0 ? -1 : scene.points[static_cast<std::size_t>(point)].label;
  };
  EXPECT_EQ(labelAt(640, 400), 2);
  EXPECT_EQ(labelAt(643, 401), 2);
  EXPECT_EQ(labelAt(650, 400), -1);
  // 1 m to the right at 2 m: 400 / tan(15 degrees) / 2 pixels
  EXPECT_EQ(labelAt(640 + 746.4, 400), 4);
  EXPECT_EQ(labelAt(640 - 746.4, 400), -1);
}

}  // namespace
}  // namespace epcc
