// SPDX-License-Identifier: BSD-3-Clause
// The paper's measures, with every threshold met exactly and missed by one pixel.
#include "eval/measures/paper_measures.h"

#include <gtest/gtest.h>

#include "tests/eval/measures/label_rows.h"

namespace {

using epcc::PaperMeasures;
using epcc::test::kIgnore;
using epcc::test::Run;
using epcc::test::tableOf;

void expectMeasures(const std::vector<Run>& runs, long n, long ic, long d, long n_o, long n_u) {
  const PaperMeasures measures = epcc::paperMeasures(tableOf(runs));
  EXPECT_EQ(measures.surfaces, n) << "N";
  EXPECT_EQ(measures.clusters, ic) << "IC";
  EXPECT_EQ(measures.detected, d) << "D";
  EXPECT_EQ(measures.over_segmented, n_o) << "N_o";
  EXPECT_EQ(measures.under_segmented, n_u) << "N_u";
}

TEST(PaperMeasures, PerfectResult) {
  expectMeasures({{50, 1, 1}, {70, 2, 2}, {9, 0, 0}}, 2, 2, 2, 0, 0);
}

TEST(PaperMeasures, DetectedFromHalfTheSurface) {
  expectMeasures({{50, 1, 1}, {50, 0, 1}}, 1, 1, 1, 0, 1);
  expectMeasures({{49, 1, 1}, {51, 0, 1}}, 1, 1, 0, 0, 0);
}

TEST(PaperMeasures, UnderSegmentedBelowFourFifths) {
  expectMeasures({{80, 1, 1}, {20, 0, 1}}, 1, 1, 1, 0, 0);
  expectMeasures({{79, 1, 1}, {21, 0, 1}}, 1, 1, 1, 0, 1);
}

TEST(PaperMeasures, OverSegmentedByTwoPartsOfATwentieth) {
  expectMeasures({{95, 1, 1}, {5, 2, 1}}, 1, 2, 1, 1, 0);
  expectMeasures({{96, 1, 1}, {4, 2, 1}}, 1, 2, 1, 0, 0);
}

TEST(PaperMeasures, FragmentsAddUpToADetection) {
  expectMeasures({{30, 1, 1}, {20, 2, 1}, {50, 0, 1}}, 1, 2, 1, 1, 1);
}

TEST(PaperMeasures, UndetectedSurfaceIsNeitherOverNorUnder) {
  expectMeasures({{20, 1, 1}, {20, 2, 1}, {60, 0, 1}}, 1, 2, 0, 0, 0);
}

TEST(PaperMeasures, APartCountsOnlyInTheClusterItsSurfaceDominates) {
  // Cluster 2 belongs to surface 2 and takes 30 of surface 1 with it.
  expectMeasures({{70, 1, 1}, {30, 2, 1}, {60, 2, 2}}, 2, 2, 2, 0, 1);
}

TEST(PaperMeasures, OneClusterOverTwoSurfacesDetectsTheLarger) {
  expectMeasures({{60, 1, 1}, {50, 1, 2}}, 2, 1, 1, 0, 0);
  expectMeasures({{50, 1, 1}, {50, 1, 2}}, 2, 1, 1, 0, 0);  // a tie goes to the first
}

TEST(PaperMeasures, NoiseCountsInTheNumberOfClustersOnly) {
  expectMeasures({{60, 1, 0}, {40, 1, 1}, {30, 2, 0}}, 1, 2, 0, 0, 0);
  expectMeasures({{40, 1, 0}, {40, 1, 1}}, 1, 1, 0, 0, 0);  // a tie is noise
}

TEST(PaperMeasures, ClusterOnIgnoredGroundIsNotCounted) {
  expectMeasures({{100, 1, 1}, {50, 2, kIgnore}, {30, 2, 0}}, 1, 1, 1, 0, 0);
}

TEST(PaperMeasures, NothingFoundNothingThereNothingScored) {
  expectMeasures({{10, 0, 1}, {10, 0, 4}}, 2, 0, 0, 0, 0);
  expectMeasures({{10, 1, 0}, {10, 4, 0}}, 0, 2, 0, 0, 0);
  expectMeasures({{10, 1, kIgnore}}, 0, 0, 0, 0, 0);
}

TEST(PaperMeasures, AddUp) {
  PaperMeasures sum{5, 7, 4, 2, 1};
  sum += PaperMeasures{10, 20, 30, 40, 50};
  EXPECT_EQ(sum.surfaces, 15);
  EXPECT_EQ(sum.clusters, 27);
  EXPECT_EQ(sum.detected, 34);
  EXPECT_EQ(sum.over_segmented, 42);
  EXPECT_EQ(sum.under_segmented, 51);
}

}  // namespace
