// SPDX-License-Identifier: BSD-3-Clause
// What bins of blocks make of blocks of half the size.
#include "sensor/depth_bins.h"

#include <gtest/gtest.h>

#include <vector>

namespace {

using epcc::BlockResiduals;

/// Blocks two metres away: so many with an error of a millimetre, and so many of clutter, rougher by a factor.
std::vector<BlockResiduals> blocks(int flat, int cluttered, double factor) {
  std::vector<BlockResiduals> result;
  for (int i = 0; i < flat + cluttered; ++i) {
    BlockResiduals block;
    block.depth = 2.0;
    block.deviation = i < flat ? 0.001 : 0.001 * factor;
    result.push_back(block);
  }
  return result;
}

/// The deviation of a bin of these blocks, in millimetres, if blocks of half the size have one of a third of it.
double guarded(const std::vector<BlockResiduals>& whole) {
  std::vector<BlockResiduals> halves(8);
  for (BlockResiduals& half : halves) {
    half.depth = 2.0;
    half.deviation = 0.001 / 3.3;
  }
  epcc::DepthBins bins;
  bins.sort(whole);
  EXPECT_EQ(bins.size(), 1u);
  bins.findDeviations(epcc::SigmaShape(), 0.0);
  bins.guardAgainstClutter(halves, 0.0, 1.0);
  return 1e3 * bins[0].deviation;
}

// Where the error differs from place to place, or its blotches grow with the depth, halves say less than there is.
TEST(DepthBins, BlocksThatAgreeKnowBetterThanTheirHalves) {
  EXPECT_NEAR(guarded(blocks(10, 0, 1.0)), 1.0, 1e-6);
  EXPECT_NEAR(guarded(blocks(5, 25, 1.4)), 1.4, 1e-6) << "the low quantile is that of the rougher ones";
  EXPECT_NEAR(guarded(blocks(8, 22, 1.4)), 1.0, 1e-6);
}

TEST(DepthBins, HalvesFitBetweenTheClutter) {
  EXPECT_NEAR(guarded(blocks(8, 22, 1.6)), 1.0 / 3.0, 1e-6);
  EXPECT_NEAR(guarded(blocks(9, 0, 1.0)), 1.0 / 3.0, 1e-6) << "too few to agree";
}

}  // namespace
