// SPDX-License-Identifier: BSD-3-Clause
// Memory that runs out at any moment of an extraction, in any thread, is an error in words.
#include <gtest/gtest.h>

#include "epcc_segmentation/plane_extractor.h"
#include "tests/support/failing_allocations.h"
#include "tests/support/refused_threads.h"
#include "tests/support/rendered_room.h"

namespace {

using epcc::Parameters;
using epcc::PlaneExtractor;
using epcc::PlaneSegmentation;
using epcc::SensorModel;

epcc::test::RenderedRoom smallRoom() {
  return epcc::test::renderRoom(epcc::test::cornerPlanes(), epcc::test::testCamera(48, 36));
}

Parameters parametersOf(epcc::Mode mode, int threads) {
  Parameters parameters = mode == epcc::Mode::Paper ? Parameters::forPaper() : Parameters();
  parameters.threads = threads;
  return parameters;
}

class OutOfMemory : public testing::TestWithParam<std::tuple<epcc::Mode, int>> {
 protected:
  const Parameters parameters_ = parametersOf(std::get<0>(GetParam()), std::get<1>(GetParam()));
  const SensorModel sensor_ = SensorModel::axial(0.001, 0.001);
};

TEST_P(OutOfMemory, AtAnyAllocationIsAnErrorAndTheNextFrameIsFine) {
  const auto room = smallRoom();
  PlaneSegmentation expected;
  ASSERT_TRUE(PlaneExtractor(parameters_, sensor_).extract(room.frame(), expected));
  ASSERT_EQ(expected.planes.size(), 3U);
  int refused = 0;
  bool ran_out = true;
  for (long allowed = 0; ran_out; ++allowed) {
    PlaneExtractor extractor(parameters_, sensor_);
    PlaneSegmentation result;
    bool done = false;
    {
      const epcc::test::FailingAllocations memory(allowed);
      done = extractor.extract(room.frame(), result);
      ran_out = memory.happened();
    }
    if (!done) {
      ++refused;
      ASSERT_TRUE(ran_out);
      ASSERT_EQ(extractor.error(), "out of memory");
      ASSERT_TRUE(result.labels.empty() && result.planes.empty());
      ASSERT_TRUE(extractor.extract(room.frame(), result));
    }
    ASSERT_EQ(extractor.error(), "");
    ASSERT_EQ(result.labels, expected.labels) << "after " << allowed << " allocations";
  }
  EXPECT_GT(refused, 20);
}

TEST_P(OutOfMemory, WithoutThreadsTheLabelsAreTheSame) {
  const auto room = smallRoom();
  PlaneSegmentation expected;
  // holdsWithoutThreads() wants none before it.
  const Parameters alone = parametersOf(std::get<0>(GetParam()), 1);
  ASSERT_TRUE(PlaneExtractor(alone, sensor_).extract(room.frame(), expected));
  EXPECT_TRUE(epcc::test::holdsWithoutThreads([&] {
    PlaneSegmentation result;
    return PlaneExtractor(parameters_, sensor_).extract(room.frame(), result) && result.labels == expected.labels;
  }));
}

INSTANTIATE_TEST_SUITE_P(Each, OutOfMemory,
                         testing::Combine(testing::Values(epcc::Mode::InverseDepth, epcc::Mode::Paper),
                                          testing::Values(1, 2, 3)),
                         [](const auto& test) {
                           return std::string(std::get<0>(test.param) == epcc::Mode::Paper ? "Paper" : "InverseDepth") +
                                  std::to_string(std::get<1>(test.param));
                         });

}  // namespace
