// SPDX-License-Identifier: BSD-3-Clause
// The error of ranges is found on scans of rooms, in spite of corners.
#include "epcc_segmentation/range_noise.h"

#include <gtest/gtest.h>

#include "tests/epcc_segmentation/laser/laser_scans.h"

namespace epcc::test {
namespace {

std::vector<LaserScan> scansWith(double a, double b) {
  std::vector<LaserScan> scans;
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  for (const double size : {0.5, 1.0, 2.0, 4.0, 8.0})
    for (int turn = 0; turn < 6; ++turn) {
      LaserScan scan = scanOf(room(-size, 1.2 * size, -0.9 * size, size), 720, 0.1 * turn, 0.5 * kDegree);
      for (double& range : scan.ranges) range += (a + b * range) * normal(random);
      scans.push_back(scan);
    }
  return scans;
}

TEST(RangeNoise, IsFoundAtAllRanges) {
  for (const auto& [a, b] : {std::pair(0.01, 0.0), std::pair(0.005, 0.003), std::pair(0.002, 0.01)}) {
    const RangeNoiseEstimate estimate = estimateRangeNoise(scansWith(a, b));
    EXPECT_GT(estimate.windows, 1000U);
    for (const double range : {0.7, 2.0, 7.0})
      EXPECT_NEAR(estimate.model().sigmaZ(range) / (a + b * range), 1.0, 0.15) << a << ' ' << b << ' ' << range;
  }
}

TEST(RangeNoise, IsGenericWhereNothingCanBeMeasured) {
  EXPECT_EQ(estimateRangeNoise({}).windows, 0U);
  LaserScan scan;
  scan.angle_increment = kDegree;
  scan.ranges.assign(360, std::numeric_limits<double>::quiet_NaN());
  const RangeNoiseEstimate estimate = estimateRangeNoise({scan});
  EXPECT_EQ(estimate.windows, 0U);
  EXPECT_EQ(estimate.a, 0.01);
  EXPECT_EQ(estimate.model().validate(), "");
}

TEST(RangeNoise, ScansWithoutErrorGiveAModelThatCanBeUsed) {
  const RangeNoiseEstimate estimate = estimateRangeNoise(scansWith(0.0, 0.0));
  EXPECT_EQ(estimate.model().validate(), "");
  EXPECT_GT(estimate.a, 0.0);
  EXPECT_LT(estimate.a, 0.001);
}

}  // namespace
}  // namespace epcc::test
