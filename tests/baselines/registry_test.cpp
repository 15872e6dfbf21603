// SPDX-License-Identifier: BSD-3-Clause
// The registry: names, Table 3 value by value, the modes of EPCC.
#include "baselines/registry.h"

#include <gtest/gtest.h>

#include "baselines/epcc_segmenter.h"
#include "tests/baselines/baseline_frames.h"

namespace epcc::test {
namespace {

TEST(Registry, KnowsItsNamesAndNoOthers) {
  EXPECT_EQ(segmenterNames(), (std::vector<std::string>{"epcc", "epcc-paper", "region-growing", "ransac", "omps"}));
  for (const auto& name : segmenterNames()) {
    const auto segmenter = makeSegmenter(name);
    ASSERT_NE(segmenter, nullptr) << name;
    EXPECT_EQ(segmenter->name(), name);
  }
  for (const char* name : {"", "EPCC", "epcc ", "region_growing", "imported"})
    EXPECT_EQ(makeSegmenter(name), nullptr) << name;
}

TEST(Registry, EpccRunsInTheModeOfItsName) {
  for (const SegmenterOptions& options : {defaultParameters(), *paperParameters('c')}) {
    EXPECT_EQ(options.epcc.mode, Mode::InverseDepth);
    EXPECT_EQ(options.epcc.scan, ScanDirection::Both);
    EXPECT_EQ(options.epcc_paper.mode, Mode::Paper);
    EXPECT_EQ(options.epcc_paper.scan, ScanDirection::Both);  // all that the mode has: columns
    EXPECT_EQ(options.epcc.validate(), "");
    EXPECT_EQ(options.epcc_paper.validate(), "");
    EXPECT_EQ(options.region_growing.validate(), "");
    EXPECT_EQ(options.ransac.validate(), "");
    EXPECT_EQ(options.organized_multi_plane.validate(), "");
  }
}

TEST(EpccSegmenter, ThatMeasuresTheSensorHeedsNoGivenOne) {
  const RenderedRoom room = noisyRoom();
  EpccSegmenter measuring(defaultParameters().epcc, SensorChoice::Measured);
  EXPECT_EQ(measuring.name(), "epcc-auto");
  PlaneSegmentation fine, coarse;
  ASSERT_TRUE(measuring.segment({room.frame(), SensorModel::axial(0.0001, 0.0001), ""}, fine));
  ASSERT_TRUE(measuring.segment({room.frame(), SensorModel::axial(0.5, 0.5, 20.0), ""}, coarse));
  EXPECT_EQ(fine.planes.size(), 3U);
  EXPECT_EQ(fine.labels, coarse.labels);
}

TEST(Registry, PaperParametersAreTable3) {
  struct Row {
    char scene;
    double leaf, curvature, smoothness, distance, weight, k_max;
  };
  const Row table[] = {{'a', 0.01, 0.3, 3.0, 0.015, 0.02, 3.0},
                       {'b', 0.03, 0.5, 4.0, 0.032, 0.02, 3.0},
                       {'c', 0.03, 0.5, 4.0, 0.05, 0.03, 2.0},
                       {'d', 0.04, 0.3, 3.0, 0.05, 0.03, 2.0}};
  for (const Row& row : table) {
    SCOPED_TRACE(row.scene);
    const auto options = paperParameters(row.scene);
    ASSERT_TRUE(options);
    const RegionGrowingParameters& growing = options->region_growing;
    EXPECT_EQ(growing.leaf.at(123.0), row.leaf);  // fixed, whatever the frame's resolution
    EXPECT_EQ(growing.curvature_threshold, row.curvature);
    EXPECT_EQ(growing.smoothness_degrees, row.smoothness);
    EXPECT_EQ(growing.normal_neighbours, 30);
    EXPECT_EQ(growing.growing_neighbours, 50);
    EXPECT_EQ(growing.min_cluster_size, 50);
    EXPECT_EQ(growing.max_cluster_size, 1000000);
    EXPECT_EQ(options->ransac.leaf.at(123.0), row.leaf);
    EXPECT_EQ(options->ransac.inlier_distance.at(123.0), row.distance);
    EXPECT_EQ(options->ransac.normal_distance_weight, row.weight);
    EXPECT_EQ(options->ransac.iterations, 100);
    const Parameters& epcc = options->epcc_paper;
    EXPECT_EQ(epcc.paper.expert.lines.minSamples(), 8);
    EXPECT_EQ(epcc.paper.line_k_max, 2.0);
    EXPECT_EQ(epcc.paper.plane_k_max, row.k_max);
    EXPECT_EQ(epcc.paper.max_gap, 0.15);
    EXPECT_EQ(epcc.paper.min_segments, 15);
  }
  for (const char scene : {'e', 'A', '\0', '`'}) EXPECT_FALSE(paperParameters(scene));
}

}  // namespace
}  // namespace epcc::test
