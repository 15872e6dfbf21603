// SPDX-License-Identifier: BSD-3-Clause
// Frames made when they are asked for, and walls with a step whose planes are known.
#include "datasets/rendered/rendered_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "datasets/rendered/scene.h"
#include "datasets/rendered/step_frames.h"

namespace epcc::test {
namespace {

TEST(RenderedFrames, AreMadeOnceAndKept) {
  int made = 0;
  const RenderedFrames frames("walls", 7, 2, [&made](std::uint64_t seed) {
    ++made;
    LabelledFrame frame;
    frame.name = "wall " + std::to_string(seed);
    return frame;
  });
  EXPECT_EQ(frames.dataset(), "walls");
  EXPECT_EQ(frames.size(), 2U);
  EXPECT_EQ(frames.name(1), "walls_8");
  EXPECT_EQ(made, 0);
  for (int again = 0; again < 2; ++again) EXPECT_EQ(frames.read(1).name, "wall 8");
  EXPECT_EQ(made, 1);
}

TEST(RenderedFrames, OfAnUnknownSceneAreRefused) {
  EXPECT_THROW(sceneWithNoise("e", NoiseOptions()), std::invalid_argument);
  EXPECT_EQ(sceneWithNoise("a", NoiseOptions())(1).labels.width, sceneWithNoise("a", NoiseOptions())(1).depth.width);
  EXPECT_EQ(sceneWithNoise("a", NoiseOptions())(1).depth.data, renderScene("a", 1).depth.data);
}

/// How far the pixels of a label lie behind the wall's plane, metres.
struct Gap {
  double least = 1e9, most = -1e9;
};

Gap gapBehind(const LabelledFrame& frame, std::uint16_t label) {
  // The wall's plane by three of its pixels, in corners that no door reaches.
  const PinholeCamera& camera = frame.camera.camera;
  const auto pointAt = [&](int row, int column) {
    const double z = static_cast<double>(frame.depth.at(row, column));
    return Eigen::Vector3d((column - camera.cx) / camera.fx * z, (row - camera.cy) / camera.fy * z, z);
  };
  const Eigen::Vector3d a = pointAt(2, 2), b = pointAt(2, camera.width - 3), c = pointAt(camera.height - 3, 2);
  const Eigen::Vector3d normal = (b - a).cross(c - a).normalized();
  Gap gap;
  for (int row = 0; row < camera.height; ++row)
    for (int column = 0; column < camera.width; ++column) {
      if (frame.labels.at(row, column) != label) continue;
      const double behind = normal.dot(pointAt(row, column) - a) * (normal.z() > 0.0 ? 1.0 : -1.0);
      gap.least = std::min(gap.least, behind);
      gap.most = std::max(gap.most, behind);
    }
  return gap;
}

TEST(StepFrames, TheSecondPlaneIsAStepBehindTheWallOrBeforeIt) {
  StepSensor sensor = kinectSensor();
  sensor.noise = NoiseOptions();  // none
  for (const std::uint64_t seed : {0U, 1U, 2U}) {
    const LabelledFrame door = stepWithNoise(doorScene(0.1), sensor)(seed);
    const Gap behind = gapBehind(door, 2);
    EXPECT_NEAR(behind.least, 0.1, 1e-4) << seed;
    EXPECT_NEAR(behind.most, 0.1, 1e-4) << seed;
    const LabelledFrame picture = stepWithNoise(pictureFrameScene(0.02), sensor)(seed);
    const Gap before = gapBehind(picture, 2);
    EXPECT_NEAR(before.least, -0.02, 1e-4) << seed;
    EXPECT_NEAR(before.most, -0.02, 1e-4) << seed;
    EXPECT_GT(std::count(picture.labels.data.begin(), picture.labels.data.end(), kIgnoreLabel), 10000) << "inside";
  }
}

TEST(StepFrames, HaveTheErrorOfTheirSensor) {
  for (const StepSensor& sensor : {kinectSensor(), realsenseSensor()}) {
    StepSensor exact = sensor;
    exact.noise = NoiseOptions();
    const LabelledFrame frame = stepWithNoise(doorScene(0.1), sensor)(3),
                        truth = stepWithNoise(doorScene(0.1), exact)(3);
    EXPECT_EQ(frame.camera.noise, sensor.noise.preset);
    double squares = 0.0;
    int count = 0;
    for (std::size_t i = 0; i < frame.depth.data.size(); ++i) {
      if (!(frame.depth.data[i] > 0.0F)) continue;
      const auto error = static_cast<double>(frame.depth.data[i] - truth.depth.data[i]);
      squares += error * error;
      ++count;
    }
    EXPECT_GT(count, 100000) << sensor.name;
    EXPECT_GT(std::sqrt(squares / count), 0.005) << sensor.name;
    EXPECT_LT(std::sqrt(squares / count), 0.1) << sensor.name;
  }
}

}  // namespace
}  // namespace epcc::test
