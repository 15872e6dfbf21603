// SPDX-License-Identifier: BSD-3-Clause
// The extractor keeps a frame's memory: from the second frame on nothing as large as an image is allocated.
#include <gtest/gtest.h>

#include "epcc_segmentation/plane_extractor.h"
#include "tests/support/failing_allocations.h"
#include "tests/support/rendered_room.h"

namespace epcc {
namespace {

constexpr std::size_t kWidth = 320;
constexpr std::size_t kHeight = 240;

class FrameMemory : public ::testing::TestWithParam<Mode> {};

TEST_P(FrameMemory, IsKeptWithAGivenAndWithAMeasuredSensor) {
  auto room = test::renderRoom(test::cornerPlanes(), test::testCamera(kWidth, kHeight));
  test::addNoise(room, SensorModel::axial(0.003, 0.0), 3);
  Parameters parameters;
  parameters.mode = GetParam();
  for (const bool measured : {false, true}) {
    PlaneExtractor extractor(parameters);
    if (!measured) extractor.setSensor(SensorModel::axial(0.003, 0.0));
    PlaneSegmentation result;
    test::forgetAllocations();
    ASSERT_TRUE(extractor.extract(room.frame(), result));
    EXPECT_GE(test::largestAllocation(), kWidth * kHeight * sizeof(float)) << "the counter sees the first frame";
    for (int frame = 0; frame < 3; ++frame) {
      test::forgetAllocations();
      ASSERT_TRUE(extractor.extract(room.frame(), result));
      EXPECT_LT(test::largestAllocation(), kWidth * kHeight) << "frame " << frame << ", measured " << measured;
    }
    extractor.setParameters(Parameters::forPaper());
    ASSERT_TRUE(extractor.extract(room.frame(), result));
    extractor.setParameters(parameters);
    test::forgetAllocations();
    ASSERT_TRUE(extractor.extract(room.frame(), result));
    EXPECT_LT(test::largestAllocation(), kWidth * kHeight) << "after a change there and back, measured " << measured;
  }
}

INSTANTIATE_TEST_SUITE_P(Modes, FrameMemory, ::testing::Values(Mode::InverseDepth, Mode::Paper),
                         [](const auto& mode) { return mode.param == Mode::Paper ? "Paper" : "InverseDepth"; });

}  // namespace
}  // namespace epcc
