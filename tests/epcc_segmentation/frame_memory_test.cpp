// SPDX-License-Identifier: BSD-3-Clause
// The extractor keeps a frame's memory: from the second frame on nothing as large as an image is allocated.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "epcc_segmentation/plane_extractor.h"
#include "tests/support/rendered_room.h"

namespace {
std::atomic<std::size_t> largest_allocation{0};
}  // namespace

// Counts what the program and the library allocate.
// Not inlined: GCC would see malloc() meet delete.
__attribute__((noinline)) void* operator new(std::size_t size) {
  std::size_t largest = largest_allocation.load();
  while (size > largest && !largest_allocation.compare_exchange_weak(largest, size)) {
  }
  if (void* memory = std::malloc(size == 0 ? 1 : size)) return memory;
  throw std::bad_alloc();
}
__attribute__((noinline)) void operator delete(void* memory) noexcept {
  std::free(memory);
}
__attribute__((noinline)) void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}

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
    largest_allocation = 0;
    ASSERT_TRUE(extractor.extract(room.frame(), result));
    EXPECT_GE(largest_allocation.load(), kWidth * kHeight * sizeof(float)) << "the counter sees the first frame";
    for (int frame = 0; frame < 3; ++frame) {
      largest_allocation = 0;
      ASSERT_TRUE(extractor.extract(room.frame(), result));
      EXPECT_LT(largest_allocation.load(), kWidth * kHeight) << "frame " << frame << ", measured " << measured;
    }
    extractor.setParameters(Parameters::forPaper());
    ASSERT_TRUE(extractor.extract(room.frame(), result));
    extractor.setParameters(parameters);
    largest_allocation = 0;
    ASSERT_TRUE(extractor.extract(room.frame(), result));
    EXPECT_LT(largest_allocation.load(), kWidth * kHeight) << "after a change there and back, measured " << measured;
  }
}

INSTANTIATE_TEST_SUITE_P(Modes, FrameMemory, ::testing::Values(Mode::InverseDepth, Mode::Paper),
                         [](const auto& mode) { return mode.param == Mode::Paper ? "Paper" : "InverseDepth"; });

}  // namespace
}  // namespace epcc
