// SPDX-License-Identifier: BSD-3-Clause
// The comparison's rows, numbers, files and picture on scene a with two seeds.
#include "eval/comparison/comparison.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "eval/comparison/comparison_figure.h"
#include "eval/comparison/comparison_report.h"

namespace epcc {
namespace {

ComparisonOptions smallOptions() {
  ComparisonOptions options;
  options.scenes = {"a"};
  options.noise = parseNoise("stereo").value();
  options.seeds = 2;
  options.slow_seeds = 1;
  return options;
}

/// Run once for all tests: the baselines take a second a frame.
const Comparison& smallComparison() {
  static const Comparison comparison = runComparison(smallOptions());
  return comparison;
}

TEST(ScoreStatistics, MeanAndSampleDeviation) {
  Scores one{}, two{};
  one[kClusters] = 4.0;
  two[kClusters] = 8.0;
  EXPECT_DOUBLE_EQ(meanScores({one, two})[kClusters], 6.0);
  EXPECT_NEAR(deviationScores({one, two})[kClusters], 2.8284, 1e-4);
  EXPECT_EQ(deviationScores({one})[kClusters], 0.0);
  EXPECT_EQ(meanScores({})[kClusters], 0.0);
}

TEST(ScoreStatistics, SharesAreOfTheSurfaces) {
  FrameMeasures measures;
  measures.paper = {10, 14, 8, 3, 1};
  const Scores scores = scoresOf(measures);
  EXPECT_EQ(scores[kClusters], 14.0);
  EXPECT_EQ(scores[kDetected], 8.0);
  EXPECT_DOUBLE_EQ(scores[kDetectedShare], 0.8);
  EXPECT_DOUBLE_EQ(scores[kOverShare], 0.3);
  EXPECT_DOUBLE_EQ(scores[kUnderShare], 0.1);
  EXPECT_EQ(scoresOf(FrameMeasures())[kDetectedShare], 0.0);
}

TEST(PublishedTable4, HasThePapersNumbers) {
  EXPECT_EQ(publishedTable4("a", "region-growing").value(), (PublishedScores{6, 5, 1.00, 0.00, 0.20}));
  EXPECT_EQ(publishedTable4("c", "ransac").value(), (PublishedScores{25, 9, 1.00, 0.66, 0.00}));
  EXPECT_EQ(publishedTable4("d", "epcc-paper").value(), (PublishedScores{14, 8, 0.89, 0.22, 0.00}));
  EXPECT_DOUBLE_EQ(publishedTable4("mean", "epcc-paper").value()[0], 11.5);
  EXPECT_FALSE(publishedTable4("a", "epcc").has_value());
  EXPECT_FALSE(publishedTable4("e", "ransac").has_value());
  EXPECT_FALSE(publishedTable4("", "ransac").has_value());
}

TEST(Comparison, HasARowForEveryMethod) {
  const Comparison& comparison = smallComparison();
  ASSERT_EQ(comparison.rows.size(), comparedMethods().size());  // no means without all four scenes
  for (std::size_t i = 0; i < comparison.rows.size(); ++i) {
    const ComparisonRow& row = comparison.rows[i];
    EXPECT_EQ(row.scene, "a");
    EXPECT_EQ(row.method, comparedMethods()[i]);
    EXPECT_EQ(row.surfaces, 5.0);
    EXPECT_EQ(row.seeds, i < 2 ? 1 : 2);
    EXPECT_EQ(row.published.has_value(), row.method != "epcc");
    EXPECT_GT(row.median_ms, 0.0);
    EXPECT_DOUBLE_EQ(row.mean[kDetectedShare], row.mean[kDetected] / 5.0);
  }
}

TEST(Comparison, RepeatsWhateverTheThreads) {
  ComparisonOptions options = smallOptions();
  options.jobs = 1;
  const Comparison again = runComparison(options);
  ASSERT_EQ(again.rows.size(), smallComparison().rows.size());
  for (std::size_t i = 0; i < again.rows.size(); ++i) {
    EXPECT_EQ(again.rows[i].mean, smallComparison().rows[i].mean);
    EXPECT_EQ(again.rows[i].deviation, smallComparison().rows[i].deviation);
  }
}

TEST(Comparison, RefusesWhatItCannotRun) {
  ComparisonOptions options = smallOptions();
  options.scenes = {"e"};
  EXPECT_THROW(runComparison(options), std::invalid_argument);
  options.scenes = {};
  EXPECT_THROW(runComparison(options), std::invalid_argument);
  options = smallOptions();
  options.seeds = 0;
  EXPECT_THROW(runComparison(options), std::invalid_argument);
}

TEST(ComparisonReport, JsonHasTheContractsKeys) {
  const auto json = nlohmann::json::parse(comparisonJson(smallComparison(), smallOptions()));
  EXPECT_EQ(json.at("version"), 1);
  EXPECT_NE(json.at("note").get<std::string>().find("surrogates"), std::string::npos);
  EXPECT_EQ(json.at("parameters"), "paper");
  ASSERT_EQ(json.at("rows").size(), 4U);
  for (const auto& row : json.at("rows")) {
    EXPECT_TRUE(row.at("scene").is_string());
    EXPECT_TRUE(row.at("method").is_string());
    EXPECT_TRUE(row.at("seeds").is_number_integer());
    for (const std::string name : {"IC", "D_over_N", "No_over_N", "Nu_over_N"}) {
      EXPECT_TRUE(row.at(name + "_mean").is_number());
      EXPECT_TRUE(row.at(name + "_std").is_number());
      EXPECT_EQ(row.at("published_" + name).is_null(), row.at("method") == "epcc");
    }
  }
  EXPECT_EQ(json.at("rows").at(0).at("published_IC"), 6.0);
}

TEST(ComparisonReport, TablesSayWhatTheyShow) {
  const Table table = comparisonTable(smallComparison());
  ASSERT_EQ(table.rows.size(), 4U);
  for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.columns.size());
  EXPECT_EQ(table.rows[0][5], "6");
  EXPECT_EQ(table.rows[3][5], "-");
  const Table numbers = comparisonNumbers(smallComparison());
  for (const auto& row : numbers.rows) EXPECT_EQ(row.size(), numbers.columns.size());
  EXPECT_EQ(comparisonNote(smallOptions()).rfind(kSurrogateNote, 0), 0U);
}

TEST(ComparisonFigure, HasARowAScene) {
  const ColorImage one = comparisonFigure(smallComparison(), "epcc-paper");
  EXPECT_GT(one.width, 5 * 320);
  EXPECT_GT(one.height, 180);
  Comparison twice = smallComparison();
  twice.frames.push_back(twice.frames[0]);
  const ColorImage two = comparisonFigure(twice, "epcc");
  EXPECT_EQ(two.width, one.width);
  EXPECT_GE(two.height, one.height + 180);
}

TEST(ComparisonFigure, LargestClusterTakesItsSurfacesLabel) {
  LabelledFrame frame;
  frame.depth = DepthImage(6, 1, 1.0F);
  frame.labels = LabelImage(6, 1);
  frame.labels.data = {7, 7, 7, 9, 9, 0};
  PlaneSegmentation segmentation;
  segmentation.width = 6;
  segmentation.height = 1;
  segmentation.labels = {3, 2, 2, 1, 1, 0};
  segmentation.planes.resize(3);
  EXPECT_EQ(labelsAsInTruth(frame, segmentation), (std::vector<std::int32_t>{10, 7, 7, 9, 9, 0}));
}

}  // namespace
}  // namespace epcc
