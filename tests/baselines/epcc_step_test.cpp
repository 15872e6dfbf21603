// SPDX-License-Identifier: BSD-3-Clause
// Steps above the error stay two surfaces: doors set back in their wall at 3 m, a frame of 3 cm at 1 m.
#include "datasets/rendered/step_frames.h"

#include <gtest/gtest.h>

#include <iostream>

#include "baselines/epcc_segmenter.h"
#include "eval/measures/frame_measures.h"

namespace epcc::test {
namespace {

constexpr int kSeeds = 10;

struct StepCase {
  const char* name;
  StepScene scene;
  StepSensor sensor;
  int separate;  ///< seeds, at least: wall and second plane correct at 80 %
};

void PrintTo(const StepCase& step, std::ostream* stream) {
  *stream << step.name;
}

class StepTest : public testing::TestWithParam<std::tuple<StepCase, SensorChoice>> {};

TEST_P(StepTest, BothSidesAreSurfacesOfTheirOwn) {
  const auto& [step, choice] = GetParam();
  EpccSegmenter segmenter(Parameters(), choice);
  const auto make = stepWithNoise(step.scene, step.sensor);
  int separate = 0;
  for (int seed = 0; seed < kSeeds; ++seed) {
    const LabelledFrame frame = make(seed);
    PlaneSegmentation result;
    ASSERT_TRUE(segmenter.segment({frameView(frame), SensorModel::preset(step.sensor.name).value(), ""}, result))
        << segmenter.error();
    separate += measureFrame(frame, result).segcomp.correct == 2 ? 1 : 0;
  }
  std::cout << separate << " of " << kSeeds << " seeds\n";
  EXPECT_GE(separate, step.separate);
}

// All ten seeds were separate when the floors were set. A door 10 cm behind its wall is left out for the RealSense:
// that is 2 sigma there, and the two became one surface for every seed.
INSTANTIATE_TEST_SUITE_P(
    Each, StepTest,
    testing::Combine(testing::Values(StepCase{"Door10cmKinect", doorScene(0.10), kinectSensor(), 9},
                                     StepCase{"Door20cmRealSense", doorScene(0.20), realsenseSensor(), 9},
                                     StepCase{"Frame3cmKinect", pictureFrameScene(0.03), kinectSensor(), 9},
                                     StepCase{"Frame3cmRealSense", pictureFrameScene(0.03), realsenseSensor(), 9}),
                     testing::Values(SensorChoice::Given, SensorChoice::Measured)),
    [](const auto& case_info) {
      return std::string(std::get<0>(case_info.param).name) +
             (std::get<1>(case_info.param) == SensorChoice::Measured ? "Auto" : "");
    });

TEST(StepFrames, SecondPlaneLiesAStepBehindOrInFront) {
  StepSensor exact = kinectSensor();
  exact.noise.kind = NoiseKind::None;
  for (const auto& [scene, step] : {std::pair(doorScene(0.10), 0.10), std::pair(pictureFrameScene(0.03), -0.03)}) {
    const LabelledFrame frame = stepWithNoise(scene, exact)(3);
    // Distances of both planes from the camera along the wall's normal.
    double distance[3] = {0.0, 0.0, 0.0};
    const double yaw = (40.0 * (4 * 0.618034 - 2.0) - 20.0) * M_PI / 180.0;
    for (int row = 0; row < 480; ++row)
      for (int column = 0; column < 640; ++column) {
        Eigen::Vector3d point;
        const int label = frame.labels.at(row, column);
        ASSERT_TRUE(frameView(frame).point(row, column, point));
        if (label == 1 || label == 2) distance[label] = std::sin(yaw) * point.x() + std::cos(yaw) * point.z();
      }
    EXPECT_NEAR(distance[2] - distance[1], step, 1e-3) << scene.name;
  }
}

}  // namespace
}  // namespace epcc::test
