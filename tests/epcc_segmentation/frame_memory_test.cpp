// SPDX-License-Identifier: BSD-3-Clause
// The extractor keeps a frame's memory: from the second frame on nothing as large as an image is allocated.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "epcc_segmentation/plane_extractor.h"
#include "tests/support/failing_allocations.h"
#include "tests/support/rendered_room.h"

namespace epcc {
namespace {

constexpr std::size_t kWidth = 320;
constexpr std::size_t kHeight = 240;

class FrameMemoryOf : public ::testing::TestWithParam<Mode> {};

TEST_P(FrameMemoryOf, IsKeptWithAGivenAndWithAMeasuredSensor) {
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

// With a sensor given. A frame may leave another more than there was: the second one finds the lists it did not.
TEST(FrameMemory, IsAllThereAfterTheSecondFrameOfTheDefaultMode) {
  for (const int width : {320, 640}) {  // all pixels, and a grid of samples
    auto room = test::renderRoom(test::cornerPlanes(), test::testCamera(width, width * 3 / 4));
    test::addNoise(room, SensorModel::axial(0.003, 0.0), 3);
    for (const int threads : {1, 2}) {
      Parameters parameters;
      parameters.threads = threads;
      PlaneExtractor extractor(parameters, SensorModel::axial(0.003, 0.0));
      PlaneSegmentation result;
      for (int frame = 0; frame < 2; ++frame) ASSERT_TRUE(extractor.extract(room.frame(), result));
      const DepthFrame frame = room.frame();
      test::forgetAllocations();
      for (int k = 0; k < 3; ++k) ASSERT_TRUE(extractor.extract(frame, result));
      EXPECT_EQ(test::largestAllocation(), 0u) << width << " columns, " << threads << " threads";
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Modes, FrameMemoryOf, ::testing::Values(Mode::InverseDepth, Mode::Paper),
                         [](const auto& mode) { return mode.param == Mode::Paper ? "Paper" : "InverseDepth"; });

// A camera's cloud in its own frame, as it comes frame by frame, and one that is turned.
TEST(FrameMemory, OfTheGeometryOfAStreamOfCloudsIsKept) {
  const auto room = test::renderRoom(test::cornerPlanes(), test::testCamera(kWidth, kHeight));
  for (const bool is_turned : {false, true}) {
    std::vector<float> xyz(3 * kWidth * kHeight, NAN);
    Eigen::Vector3d p;
    for (int row = 0; row < static_cast<int>(kHeight); ++row)
      for (int column = 0; column < static_cast<int>(kWidth); ++column)
        if (room.frame().point(row, column, p))
          for (std::size_t k = 0; k < 3; ++k)
            xyz[3 * room.frame().index(row, column) + k] =
                static_cast<float>(p(is_turned ? (k + 2) % 3 : k) + 0.5 * is_turned);
    GeometryFinder finder;
    PlaneExtractor extractor(Parameters(), SensorModel::axial(0.003, 0.0));
    PlaneSegmentation result;
    const auto work = [&] {
      const CloudGeometry& geometry = finder.find(xyz.data(), 3, kWidth, kHeight);
      ASSERT_EQ(geometry.is_plain, !is_turned);
      ASSERT_TRUE(extractor.extract(DepthFrame::fromPoints(xyz.data(), 3, kWidth, kHeight, geometry), result));
    };
    for (int frame = 0; frame < 2; ++frame) work();
    test::forgetAllocations();
    for (int frame = 0; frame < 3; ++frame) work();
    EXPECT_EQ(test::largestAllocation(), 0u) << is_turned;
  }
}

}  // namespace
}  // namespace epcc
