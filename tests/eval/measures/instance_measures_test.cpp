// SPDX-License-Identifier: BSD-3-Clause
// Matches at IoU 0.5 and their sums.
#include "eval/measures/instance_measures.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/eval/measures/label_rows.h"

namespace {

using epcc::InstanceMeasures;
using epcc::test::kIgnore;
using epcc::test::Run;
using epcc::test::tableOf;

InstanceMeasures measuresOf(const std::vector<Run>& runs) {
  return epcc::instanceMeasures(tableOf(runs));
}

TEST(InstanceMeasures, IouAndDiceOfAPair) {
  const auto matches = epcc::matchInstances(tableOf({{60, 4, 9}, {20, 4, 0}, {20, 0, 9}}));
  ASSERT_EQ(matches.size(), 1U);
  EXPECT_EQ(matches[0].surface, 1U);
  EXPECT_EQ(matches[0].cluster, 1U);
  EXPECT_DOUBLE_EQ(matches[0].iou, 0.6);
  EXPECT_DOUBLE_EQ(matches[0].dice, 0.75);
}

TEST(InstanceMeasures, MatchFromIouOneHalf) {
  EXPECT_EQ(measuresOf({{50, 1, 1}, {25, 1, 0}, {25, 0, 1}}).matched, 1);
  EXPECT_EQ(measuresOf({{50, 1, 1}, {26, 1, 0}, {25, 0, 1}}).matched, 0);
}

TEST(InstanceMeasures, AtExactlyOneHalfThePairsStayOneToOne) {
  const auto surface_halves = epcc::matchInstances(tableOf({{50, 1, 1}, {50, 2, 1}}));
  ASSERT_EQ(surface_halves.size(), 1U);
  EXPECT_EQ(surface_halves[0].cluster, 1U);
  const auto cluster_halves = epcc::matchInstances(tableOf({{50, 1, 1}, {50, 1, 2}}));
  ASSERT_EQ(cluster_halves.size(), 1U);
  EXPECT_EQ(cluster_halves[0].surface, 1U);
}

TEST(InstanceMeasures, RatiosOfAFrame) {
  // Surface 1 exactly, surface 2 with IoU 0.8, surface 3 missed; cluster 3 is noise.
  const InstanceMeasures m = measuresOf({{100, 1, 1}, {80, 2, 2}, {20, 0, 2}, {50, 0, 3}, {30, 3, 0}});
  EXPECT_DOUBLE_EQ(m.precision(), 2.0 / 3.0);
  EXPECT_DOUBLE_EQ(m.recall(), 2.0 / 3.0);
  EXPECT_DOUBLE_EQ(m.meanIou(), 0.9);
  EXPECT_NEAR(m.meanDice(), (1.0 + 160.0 / 180.0) / 2.0, 1e-6);
  EXPECT_DOUBLE_EQ(m.coverage(), 180.0 / 250.0);
}

TEST(InstanceMeasures, CoverageCountsOnlyPixelsOfTheDominantSurface) {
  const InstanceMeasures m = measuresOf({{60, 1, 1}, {40, 1, 2}, {30, 2, 1}, {40, 2, 0}, {10, 1, kIgnore}});
  EXPECT_EQ(m.plane_pixels, 130);
  EXPECT_EQ(m.dominated_pixels, 60);  // 40 lie in a foreign cluster, 30 in noise
}

TEST(InstanceMeasures, NothingToDivideByIsNotANumber) {
  const InstanceMeasures none = measuresOf({{10, 0, 0}});
  for (const double ratio : {none.precision(), none.recall(), none.meanIou(), none.meanDice(), none.coverage()})
    EXPECT_TRUE(std::isnan(ratio));
  EXPECT_TRUE(std::isnan(measuresOf({{10, 0, 1}}).precision()));
  EXPECT_EQ(measuresOf({{10, 0, 1}}).recall(), 0.0);
  EXPECT_EQ(measuresOf({{10, 1, 0}}).precision(), 0.0);
}

TEST(InstanceMeasures, SumsAreTheSumsOfTheFrames) {
  const InstanceMeasures a = measuresOf({{100, 1, 1}, {50, 0, 2}});
  InstanceMeasures sum = measuresOf({{80, 1, 1}, {20, 0, 1}, {7, 3, 0}});
  sum += a;
  EXPECT_EQ(sum.surfaces, 3);
  EXPECT_EQ(sum.clusters, 3);
  EXPECT_EQ(sum.matched, 2);
  EXPECT_EQ(sum.iou_millionths, 1800000);
  EXPECT_EQ(sum.dice_millionths, 1888889);
  EXPECT_EQ(sum.plane_pixels, 250);
  EXPECT_EQ(sum.dominated_pixels, 180);
}

}  // namespace
