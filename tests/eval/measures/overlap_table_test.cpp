// SPDX-License-Identifier: BSD-3-Clause
// What is counted, what is ignored, and which surface dominates a cluster.
#include "eval/measures/overlap_table.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/eval/measures/label_rows.h"

namespace {

using epcc::OverlapTable;
using epcc::test::kIgnore;
using epcc::test::tableOf;

using Ids = std::vector<std::int32_t>;

TEST(OverlapTable, CountsASmallImagePixelByPixel) {
  const std::vector<std::int32_t> labels = {1, 1, 2, 0,  //
                                            1, 2, 2, 0};
  const std::vector<std::int32_t> truth = {1, 1, 1, 2,  //
                                           0, 2, 2, 2};
  const OverlapTable table(labels, truth, {});
  ASSERT_EQ(table.clusterCount(), 2U);
  ASSERT_EQ(table.surfaceCount(), 2U);
  const long expected[3][3] = {{0, 0, 2}, {1, 2, 0}, {0, 1, 2}};
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t g = 0; g < 3; ++g) EXPECT_EQ(table.overlap(c, g), expected[c][g]) << c << ',' << g;
  EXPECT_EQ(table.clusterSize(1), 3);  // ground that is no plane included
  EXPECT_EQ(table.clusterSize(2), 3);
  EXPECT_EQ(table.surfaceSize(1), 3);
  EXPECT_EQ(table.surfaceSize(2), 4);  // unlabelled pixels included
}

TEST(OverlapTable, IdsMayHaveGapsAndComeInAnyOrder) {
  const OverlapTable table = tableOf({{3, 900, 40000}, {2, 7, 12}, {1, 900, 12}});
  EXPECT_EQ(table.clusterIds(), (Ids{0, 7, 900}));
  EXPECT_EQ(table.surfaceIds(), (Ids{0, 12, 40000}));
  EXPECT_EQ(table.overlap(1, 1), 2);
  EXPECT_EQ(table.overlap(2, 1), 1);
  EXPECT_EQ(table.overlap(2, 2), 3);
}

TEST(OverlapTable, PixelsWithoutDepthCountNowhere) {
  const OverlapTable table = tableOf({{4, 1, 1}, {3, 1, 1, false}, {2, 2, 1, false}, {5, 0, 3, false}});
  EXPECT_EQ(table.clusterIds(), (Ids{0, 1}));
  EXPECT_EQ(table.surfaceIds(), (Ids{0, 1}));
  EXPECT_EQ(table.clusterSize(1), 4);
  EXPECT_EQ(table.surfaceSize(1), 4);
}

TEST(OverlapTable, LabelsWithoutDepthDoNotTipTheRuleForIgnoredGround) {
  // 5 of 9 measured pixels on scored ground; with those that were not measured it would be 5 of 15.
  const OverlapTable table = tableOf({{5, 1, 1}, {4, 1, kIgnore}, {6, 1, kIgnore, false}, {100, 0, 1}});
  EXPECT_EQ(table.clusterCount(), 1U);
}

TEST(OverlapTable, DominantSurfaceIsTheLargestOverlap) {
  EXPECT_EQ(tableOf({{2, 1, 0}, {3, 1, 1}, {4, 1, 2}}).dominant(1), 2U);
  EXPECT_EQ(tableOf({{5, 1, 0}, {3, 1, 1}, {4, 1, 2}}).dominant(1), 0U);
}

TEST(OverlapTable, TiesGoToTheSmallestSurfaceZeroIncluded) {
  const OverlapTable two = tableOf({{4, 1, 8}, {4, 1, 3}});
  EXPECT_EQ(two.surfaceIds()[two.dominant(1)], 3);
  const OverlapTable three = tableOf({{4, 1, 8}, {4, 1, 3}, {4, 1, 0}});
  EXPECT_EQ(three.dominant(1), 0U);
}

TEST(OverlapTable, IgnoredGroundIsNotScored) {
  const OverlapTable table = tableOf({{6, 1, 1}, {2, 1, kIgnore}, {3, 0, kIgnore}});
  EXPECT_EQ(table.surfaceIds(), (Ids{0, 1}));
  EXPECT_EQ(table.clusterSize(1), 6);
  EXPECT_EQ(table.clusterSize(0), 0);
}

TEST(OverlapTable, ClusterMoreThanHalfOnIgnoredGroundIsNotScored) {
  const OverlapTable table = tableOf({{4, 5, 1}, {5, 5, kIgnore}, {96, 6, 1}});
  EXPECT_EQ(table.clusterIds(), (Ids{0, 6}));
  EXPECT_EQ(table.overlap(0, 1), 4) << "its pixels count as unlabelled";
  EXPECT_EQ(table.surfaceSize(1), 100);
}

TEST(OverlapTable, ClusterExactlyHalfOnIgnoredGroundIsScored) {
  EXPECT_EQ(tableOf({{5, 5, 1}, {5, 5, kIgnore}, {95, 0, 1}}).clusterIds(), (Ids{0, 5}));
}

TEST(OverlapTable, GroundThatIsNoPlaneIsScoredGround) {
  EXPECT_EQ(tableOf({{5, 5, 0}, {5, 5, kIgnore}}).clusterIds(), (Ids{0, 5}));
  EXPECT_EQ(tableOf({{5, 5, 0}, {6, 5, kIgnore}}).clusterIds(), (Ids{0}));
}

TEST(OverlapTable, HalfOfASurfaceKeepsAClusterOnIgnoredGround) {
  EXPECT_EQ(tableOf({{5, 5, 1}, {90, 5, kIgnore}, {5, 0, 1}}).clusterIds(), (Ids{0, 5}));
  EXPECT_EQ(tableOf({{5, 5, 1}, {90, 5, kIgnore}, {6, 0, 1}}).clusterIds(), (Ids{0}));
}

TEST(OverlapTable, HalfOfWhatIsNoPlaneDoesNotKeepIt) {
  EXPECT_EQ(tableOf({{5, 5, 0}, {90, 5, kIgnore}}).clusterIds(), (Ids{0}));
}

TEST(OverlapTable, EmptyPredictionEmptyTruthEverythingIgnored) {
  const OverlapTable prediction = tableOf({{10, 0, 1}, {5, 0, 0}});
  EXPECT_EQ(prediction.clusterCount(), 0U);
  EXPECT_EQ(prediction.overlap(0, 1), 10);
  const OverlapTable truth = tableOf({{10, 1, 0}});
  EXPECT_EQ(truth.surfaceCount(), 0U);
  EXPECT_EQ(truth.dominant(1), 0U);
  const OverlapTable ignored = tableOf({{10, 1, kIgnore}, {10, 0, kIgnore}});
  EXPECT_EQ(ignored.clusterCount() + ignored.surfaceCount(), 0U);
  const OverlapTable nothing({}, {}, {});
  EXPECT_EQ(nothing.clusterCount() + nothing.surfaceCount(), 0U);
}

TEST(OverlapTable, RefusesArraysThatDoNotFit) {
  EXPECT_THROW(OverlapTable({1, 1}, {1}, {}), std::invalid_argument);
  EXPECT_THROW(OverlapTable({1, 1}, {1, 1}, {1}), std::invalid_argument);
  EXPECT_THROW(OverlapTable({-1}, {1}, {}), std::invalid_argument);
  EXPECT_THROW(OverlapTable({1}, {-1}, {}), std::invalid_argument);
}

}  // namespace
