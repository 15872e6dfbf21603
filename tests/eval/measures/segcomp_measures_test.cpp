// SPDX-License-Identifier: BSD-3-Clause
// The five SegComp classes, their edges at the tolerance, and regions that qualify for two of them.
#include "eval/measures/segcomp_measures.h"

#include <gtest/gtest.h>

#include "tests/eval/measures/label_rows.h"

namespace {

using epcc::SegcompMeasures;
using epcc::test::kIgnore;
using epcc::test::Run;
using epcc::test::tableOf;

void expectClasses(const std::vector<Run>& runs, long correct, long over, long under, long missed, long noise,
                   double tolerance = 0.8) {
  const SegcompMeasures measures = epcc::segcompMeasures(tableOf(runs), tolerance);
  EXPECT_EQ(measures.correct, correct) << "correct";
  EXPECT_EQ(measures.over, over) << "over";
  EXPECT_EQ(measures.under, under) << "under";
  EXPECT_EQ(measures.missed, missed) << "missed";
  EXPECT_EQ(measures.noise, noise) << "noise";
}

TEST(SegcompMeasures, Correct) {
  expectClasses({{50, 1, 1}, {70, 2, 2}}, 2, 0, 0, 0, 0);
}

TEST(SegcompMeasures, CorrectFromFourFifthsOfTheSurface) {
  expectClasses({{80, 1, 1}, {20, 0, 1}}, 1, 0, 0, 0, 0);
  expectClasses({{79, 1, 1}, {21, 0, 1}}, 0, 0, 0, 1, 1);
}

TEST(SegcompMeasures, CorrectFromFourFifthsOfTheCluster) {
  expectClasses({{80, 1, 1}, {20, 1, 0}}, 1, 0, 0, 0, 0);
  expectClasses({{79, 1, 1}, {21, 1, 0}}, 0, 0, 0, 1, 1);
}

TEST(SegcompMeasures, OverFromFourFifthsTogether) {
  expectClasses({{40, 1, 1}, {40, 2, 1}, {20, 0, 1}}, 0, 1, 0, 0, 0);
  expectClasses({{40, 1, 1}, {39, 2, 1}, {21, 0, 1}}, 0, 0, 0, 1, 2);
}

TEST(SegcompMeasures, OverNeedsEachClusterOnTheSurface) {
  expectClasses({{40, 1, 1}, {10, 1, 0}, {60, 2, 1}}, 0, 1, 0, 0, 0);  // cluster 1: exactly 80 %
  expectClasses({{40, 1, 1}, {11, 1, 0}, {60, 2, 1}}, 0, 0, 0, 1, 2);
}

TEST(SegcompMeasures, UnderFromFourFifthsTogether) {
  expectClasses({{40, 1, 1}, {40, 1, 2}, {20, 1, 0}}, 0, 0, 1, 0, 0);
  expectClasses({{40, 1, 1}, {40, 1, 2}, {21, 1, 0}}, 0, 0, 0, 2, 1);
}

TEST(SegcompMeasures, UnderNeedsEachSurfaceInTheCluster) {
  expectClasses({{40, 1, 1}, {10, 0, 1}, {60, 1, 2}}, 0, 0, 1, 0, 0);  // surface 1: exactly 80 %
  expectClasses({{40, 1, 1}, {11, 0, 1}, {60, 1, 2}}, 0, 0, 0, 2, 1);
}

TEST(SegcompMeasures, MissedAndNoise) {
  expectClasses({{50, 0, 1}, {50, 1, 0}}, 0, 0, 0, 1, 1);
  expectClasses({{50, 0, 1}, {50, 0, 7}}, 0, 0, 0, 2, 0);
  expectClasses({{50, 3, 0}, {50, 9, 0}}, 0, 0, 0, 0, 2);
  expectClasses({{50, 3, kIgnore}}, 0, 0, 0, 0, 0);
}

TEST(SegcompMeasures, AllFiveClassesInOneImage) {
  expectClasses({{50, 1, 1},  // correct
                 {25, 2, 2},
                 {25, 3, 2},  // over
                 {25, 4, 3},
                 {25, 4, 4},  // under
                 {50, 0, 5},
                 {50, 5, 0}},  // missed, noise
                1, 1, 1, 1, 1);
}

TEST(SegcompMeasures, CorrectBeatsOverByItsMeanOverlap) {
  // Correct: (1 + 0.8) / 2 = 0.90. Over: (mean(1, 0.8) + 0.96) / 2 = 0.93, so the surface is over-segmented.
  expectClasses({{80, 1, 1}, {16, 2, 1}, {4, 2, 0}, {4, 0, 1}}, 0, 1, 0, 0, 0);
  // Correct: (1 + 0.98) / 2 = 0.99. Over: (0.9 + 1) / 2 = 0.95, so cluster 2 is noise.
  expectClasses({{392, 1, 1}, {8, 2, 1}, {2, 2, 0}}, 1, 0, 0, 0, 1);
}

TEST(SegcompMeasures, CorrectAgainstUnderByItsMeanOverlap) {
  expectClasses({{80, 1, 1}, {16, 1, 2}, {4, 0, 2}, {4, 1, 0}}, 0, 0, 1, 0, 0);
  expectClasses({{392, 1, 1}, {8, 1, 2}, {2, 0, 2}}, 1, 0, 0, 1, 0);
}

TEST(SegcompMeasures, IgnoredGroundAndMissingDepthDoNotCount) {
  expectClasses({{80, 1, 1}, {20, 0, 1}, {30, 1, kIgnore}, {99, 1, 0, false}, {99, 0, 1, false}}, 1, 0, 0, 0, 0);
}

TEST(SegcompMeasures, EdgesAreExactAtEveryTolerance) {
  for (int percent = 51; percent <= 100; ++percent)
    for (const int hundreds : {1, 3, 7, 11}) {
      const int inside = percent * hundreds, rest = (100 - percent) * hundreds;
      SCOPED_TRACE(std::to_string(percent) + " % of " + std::to_string(100 * hundreds));
      expectClasses({{inside, 1, 1}, {rest, 0, 1}}, 1, 0, 0, 0, 0, percent / 100.0);
      expectClasses({{inside - 1, 1, 1}, {rest + 1, 0, 1}}, 0, 0, 0, 1, 1, percent / 100.0);
    }
}

TEST(SegcompMeasures, AddUp) {
  SegcompMeasures sum{1, 2, 3, 4, 5};
  sum += SegcompMeasures{10, 20, 30, 40, 50};
  EXPECT_EQ(sum.correct, 11);
  EXPECT_EQ(sum.over, 22);
  EXPECT_EQ(sum.under, 33);
  EXPECT_EQ(sum.missed, 44);
  EXPECT_EQ(sum.noise, 55);
}

}  // namespace
