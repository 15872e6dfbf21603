// SPDX-License-Identifier: BSD-3-Clause
// On a real sequence the same surfaces are found again a few frames later.
#include <gtest/gtest.h>

#include <memory>

#include "baselines/epcc_segmenter.h"
#include "datasets/sources/native_folder.h"
#include "eval/experiment/sequence_repeatability.h"
#include "tests/support/real_frames.h"

namespace epcc::test {
namespace {

TEST(RealSequence, MostOfAKitchenIsFoundAgain) {
  EPCC_NEED_REAL_FRAMES("sequence");
  std::vector<std::unique_ptr<FrameSource>> sources;
  sources.push_back(std::make_unique<NativeFolder>(realFolder("sequence")));
  FrameJobs jobs = listJobs(sources);
  jobs.keepFirst(40);
  const auto measuring = [] { return std::make_unique<EpccSegmenter>(Parameters(), SensorChoice::Measured); };
  const SequenceResult result = measureSequences(
      jobs, {registeredMethod("epcc"), {"epcc-auto", measuring, true}, registeredMethod("omps")}, {"", {5}});
  EXPECT_TRUE(result.problems.empty());
  ASSERT_EQ(result.rows.size(), 3U);
  const auto share = [&](std::size_t row) {
    const Repeatability& sums = result.rows[row].sums;
    EXPECT_EQ(sums.pairs, 35);
    EXPECT_GT(sums.shared, 35 * 200000) << "most of a view is in the next ones, too";
    return static_cast<double>(sums.repeated_pixels) / static_cast<double>(sums.shared);
  };
  const double preset = share(0), measured = share(1), other = share(2);
  RecordProperty("preset", std::to_string(preset));
  RecordProperty("measured", std::to_string(measured));
  EXPECT_GT(preset, 0.85);
  EXPECT_GT(measured, 0.85);
  EXPECT_GT(preset, other) << "a method that knows no noise";
  EXPECT_LT(*result.rows[0].sums.millidegrees.median(), 2000.0);
  EXPECT_LT(*result.rows[0].sums.micrometres.median(), 10000.0);
}

}  // namespace
}  // namespace epcc::test
