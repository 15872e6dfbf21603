// SPDX-License-Identifier: BSD-3-Clause
// On floor plans the walls are found where they are, and more of them than by other methods.
#include "eval/line_study/line_study.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>

#include "baselines/laser_line_methods.h"
#include "datasets/support/quantile.h"
#include "eval/line_study/line_study_command.h"
#include "tests/support/run_tool.h"

namespace epcc::test {
namespace {

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double shareBelow(const std::vector<double>& values, double limit) {
  const auto below = std::count_if(values.begin(), values.end(), [&](double value) { return value <= limit; });
  return static_cast<double>(below) / static_cast<double>(values.size());
}

class LineStudy : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    LineStudyOptions options;
    options.plans = 2;
    options.scans = 20;
    for (const LineStudyRow& row : runLineStudy(options)) rows()[row.sensor + ", " + row.method] = row.scores;
  }
  static std::map<std::string, LineScores>& rows() {
    static std::map<std::string, LineScores> all;
    return all;
  }
};

TEST_F(LineStudy, WallsAreFound) {
  for (const char* sensor : {"0.5°, 360°", "1°, 180°"}) {
    const LineScores& s = rows().at(std::string(sensor) + ", EPCC, noise given");
    EXPECT_GT(s.faces, 150);
    EXPECT_GE(static_cast<double>(s.regions.correct), 0.95 * static_cast<double>(s.faces)) << sensor;
    EXPECT_LE(s.regions.under, 1) << sensor;
    EXPECT_LT(median(s.angle_errors), 0.004);
    EXPECT_LT(median(s.distance_errors), 0.002);
  }
}

TEST_F(LineStudy, UncertaintyIsThatOfTheErrors) {
  for (const char* noise : {"given", "measured"}) {
    const LineScores& s = rows().at(std::string("0.5°, 360°, EPCC, noise ") + noise);
    EXPECT_GT(mean(s.clear_line_nees), 1.6) << noise;
    EXPECT_LT(mean(s.clear_line_nees), 3.0) << noise;
    EXPECT_GT(shareBelow(s.end_nees, 11.83), 0.91) << noise;
  }
}

TEST_F(LineStudy, OtherMethodsFindFewer) {
  const auto correct = [](const char* method) {
    return rows().at(std::string("0.5°, 360°, ") + method).regions.correct;
  };
  EXPECT_GT(correct("Split-and-Merge"), 100);
  EXPECT_GT(correct("PCL RANSAC line"), 100);
  EXPECT_GT(correct("EPCC, hidden parts not joined"), correct("Split-and-Merge"));
  EXPECT_GT(correct("EPCC, hidden parts not joined"), correct("PCL RANSAC line"));
  EXPECT_GT(correct("EPCC, noise given"), correct("EPCC, hidden parts not joined"));
}

TEST(WallsOfManyBeams, AreAllFound) {
  LaserLineExtractor extractor(SensorModel::polynomial(0.0, 0.001, 0.01));
  for (const FloorScan& scan : scanOffice(LaserSensor::allRound(), 20, 5)) {
    LaserLines lines;
    ASSERT_TRUE(extractor.extract(scan.record.scan, lines));
    for (const SeenFace& face : scan.faces) {
      if (face.beams.size() < 20) continue;
      const bool found = std::any_of(face.beams.begin(), face.beams.end(),
                                     [&](int beam) { return lines.labels[static_cast<std::size_t>(beam)] > 0; });
      EXPECT_TRUE(found) << face.beams.size() << " beams from " << face.beams.front();
    }
  }
}

TEST(OtherLineMethods, FindTheSidesOfARoom) {
  FloorPlan plan;
  const Vector2 corners[] = {{0.0, 0.0}, {4.0, 0.0}, {4.0, 3.0}, {0.0, 3.0}};
  for (int i = 0; i < 4; ++i) plan.faces.push_back({corners[i], corners[(i + 1) % 4]});
  const FloorScan scan = scanFloor(plan, LaserSensor::allRound(), {1.5, 1.2, 0.7}, 1);
  for (const auto method : {splitAndMergeLines, ransacLines}) {
    LaserMethodParameters parameters;
    parameters.distance = 0.06;
    const std::vector<MethodLine> lines = method(scan.record.scan, parameters);
    EXPECT_GE(lines.size(), 4U);
    EXPECT_LE(lines.size(), 6U);  // the seam cuts one; what is left of a corner may be another
    for (const MethodLine& line : lines) {
      if (line.beams.size() < 30) continue;
      EXPECT_TRUE(std::any_of(scan.faces.begin(), scan.faces.end(),
                              [&](const SeenFace& face) {
                                return std::abs(std::remainder(line.alpha - face.alpha, 6.283185307)) < 0.02 &&
                                       std::abs(line.rho - face.rho) < 0.02;
                              }))
          << line.alpha << ' ' << line.rho;
    }
    EXPECT_TRUE(method(LaserScan(), parameters).empty());
  }
}

TEST(LineStudyCommand, PrintsTables) {
  const ToolResult result = callTool(lineStudyMain, "epcc_line_study", {"--plans", "1", "--scans", "2"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_NE(result.out.find("| Split-and-Merge |"), std::string::npos);
  expectFailure(callTool(lineStudyMain, "epcc_line_study", {"--plans", "0"}), "epcc_line_study", 2, "--plans");
}

}  // namespace
}  // namespace epcc::test
