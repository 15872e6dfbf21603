// SPDX-License-Identifier: BSD-3-Clause
// Depth images taken as the options say, number by number.
#include "datasets/sources/reading_options.h"

#include <gtest/gtest.h>

#include <cmath>

namespace epcc::test {
namespace {

/// Numbers 1000, 2000, 0 and 3000 in millimetres, all on one row; the camera looks at the first.
LabelledFrame fourDepths() {
  LabelledFrame frame;
  frame.camera.camera = {4, 1, 2.0, 2.0, 0.0, 0.0};
  frame.camera.depth_scale = 0.001;
  frame.depth = DepthImage(4, 1);
  frame.depth.data = {1.0F, 2.0F, 0.0F, 3.0F};
  return frame;
}

std::vector<float> depthsReadAs(const ReadingOptions& options) {
  LabelledFrame frame = fourDepths();
  readAs(frame, options);
  return frame.depth.data;
}

TEST(ReadingOptions, WithoutAnyAFrameStaysAsItIs) {
  EXPECT_TRUE(ReadingOptions().areDefault());
  EXPECT_EQ(depthsReadAs({}), fourDepths().depth.data);
}

TEST(ReadingOptions, EachIsNotDefault) {
  ReadingOptions sensor, unit, invalid, near, far, distance;
  sensor.sensor = CloudOptions::Sensor::Camera;
  unit.unit = 1.0;
  invalid.invalid = 0.0;
  near.min_depth = 0.1;
  far.max_depth = 9.0;
  distance.is_distance = true;
  for (const ReadingOptions* options : {&sensor, &unit, &invalid, &near, &far, &distance})
    EXPECT_FALSE(options->areDefault());
}

TEST(ReadingOptions, DepthsInAnotherUnit) {
  ReadingOptions options;
  options.unit = 0.002;
  const std::vector<float> depths = depthsReadAs(options);
  EXPECT_FLOAT_EQ(depths[0], 2.0F);
  EXPECT_FLOAT_EQ(depths[3], 6.0F);
  EXPECT_FALSE(depths[2] > 0.0F);
}

TEST(ReadingOptions, ANumberThatStandsForNothing) {
  ReadingOptions options;
  options.invalid = 2000.0;
  const std::vector<float> depths = depthsReadAs(options);
  EXPECT_FALSE(depths[1] > 0.0F);
  EXPECT_FLOAT_EQ(depths[3], 3.0F);
}

TEST(ReadingOptions, NearerAndFartherIsNotMeasured) {
  ReadingOptions options;
  options.min_depth = 1.5;
  options.max_depth = 2.5;
  const std::vector<float> depths = depthsReadAs(options);
  EXPECT_FALSE(depths[0] > 0.0F);
  EXPECT_FLOAT_EQ(depths[1], 2.0F);
  EXPECT_FALSE(depths[3] > 0.0F);
}

TEST(ReadingOptions, LengthsOfRaysAreLongerThanDepths) {
  ReadingOptions options;
  options.is_distance = true;
  const std::vector<float> depths = depthsReadAs(options);
  EXPECT_FLOAT_EQ(depths[0], 1.0F);
  EXPECT_FLOAT_EQ(depths[1], 2.0F / std::sqrt(1.25F));
}

}  // namespace
}  // namespace epcc::test
