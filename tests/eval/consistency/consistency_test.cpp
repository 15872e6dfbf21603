// SPDX-License-Identifier: BSD-3-Clause
// epcc_consistency: its numbers, its files, its command line.
#include "eval/consistency/consistency.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "eval/consistency/consistency_command.h"
#include "eval/consistency/consistency_report.h"
#include "tests/support/run_tool.h"
#include "tests/support/temp_folder.h"

namespace epcc {
namespace {

TEST(Consistency, OfAPlaneIsInUnitsOfItsCovarianceWhicheverWayTheTruthPoints) {
  Plane plane;
  plane.coefficients << 0.0, 0.0, -1.0, 2.02;
  plane.coefficients_covariance.diagonal() << 1e-4, 1e-4, 0.0, 1e-4;
  EXPECT_NEAR(normalisedSquaredError(plane, Vector4(0.0, 0.0, -1.0, 2.0)), 4.0, 1e-9);
  EXPECT_NEAR(normalisedSquaredError(plane, Vector4(0.0, 0.0, 1.0, -2.0)), 4.0, 1e-9);
}

TEST(Consistency, OfALineIsInUnitsOfItsCovariance) {
  LineSegment segment;
  segment.theta << 0.53, 0.0;
  segment.theta_covariance << 1e-4, 0.0, 0.0, 1e-4;
  EXPECT_NEAR(normalisedSquaredError(segment, Vector2(0.5, 0.04)), 25.0, 1e-9);
}

TEST(Consistency, ChiSquareDistributionsAreThoseOfTables) {
  EXPECT_NEAR(chiSquareBelow(5.991, 2), 0.95, 1e-4);
  EXPECT_NEAR(chiSquareBelow(7.815, 3), 0.95, 1e-4);
  EXPECT_NEAR(chiSquareBelow(2.366, 3), 0.5, 1e-4);
  EXPECT_EQ(chiSquareBelow(0.0, 3), 0.0);
}

std::vector<ConsistencyRow> twoRows() {
  ConsistencyRow planes{"white", "exact", 3, {1.0, 2.0, 9.0}, {"a1", "a2", "a1"}, {9.0, 2.0, 1.0}};
  ConsistencyRow lines{"white", "exact", 2, {1.0, 3.0}, {}, {}};
  return {planes, lines, {"stereo", "exact", 3, {}, {}, {}}};
}

TEST(Consistency, TablesHaveMeansAndLeaveOutWhatWasNotRun) {
  const Table table = consistencyTable(twoRows());
  ASSERT_EQ(table.rows.size(), 2u);
  EXPECT_EQ(table.rows[0], (std::vector<std::string>{"white", "planes", "exact", "3", "4.00", "2.00", "66.7"}));
  EXPECT_EQ(table.rows[1], (std::vector<std::string>{"white", "lines", "exact", "2", "2.00", "1.00", "100.0"}));
  const Table surfaces = surfacesTable(twoRows());
  ASSERT_EQ(surfaces.rows.size(), 2u);
  EXPECT_EQ(surfaces.rows[0], (std::vector<std::string>{"white", "exact", "a1", "2", "5.000"}));
}

TEST(Consistency, ChartsRiseToTheShareThatLiesBelow) {
  const Plot plot = consistencyChart(twoRows(), 3);
  ASSERT_EQ(plot.series.size(), 2u);
  EXPECT_NEAR(plot.series[0].points.front().y, 0.0, 1e-12);
  EXPECT_NEAR(plot.series[0].points.back().y, 1.0, 1e-12);
  for (const PlotPoint& point : plot.series[0].points) {
    if (point.x > 2.1 && point.x < 8.9) {
      EXPECT_NEAR(point.y, 2.0 / 3.0, 1e-12);
    }
  }
}

class ConsistencyCommand : public test::TempFolderTest {
 protected:
  static test::ToolResult run(const std::vector<std::string>& arguments) {
    return test::callTool(consistencyMain, "epcc_consistency", arguments);
  }
};

TEST_F(ConsistencyCommand, LeavesTablesAndPicturesWithMeansNearTheNumbersOfParameters) {
  const auto done = run({"--runs", "2", "--out", path("out")});
  ASSERT_EQ(done.exit_code, 0) << done.err;
  for (const char* file : {"consistency.csv", "surfaces.csv", "planes.png", "lines.png"})
    EXPECT_TRUE(std::filesystem::exists(path("out/" + std::string(file)))) << file;
  const auto json = nlohmann::json::parse(read("out/consistency.json"));
  EXPECT_EQ(json["version"], 1);
  ASSERT_EQ(json["rows"].size(), 14u);  // three errors in four ways, stereo in two
  for (const auto& row : json["rows"]) {
    if (row["labels"] != "exact") continue;
    const double parameters = row["parameters"];
    EXPECT_NEAR(row["mean"].get<double>() / parameters, 1.0, 0.5) << row;
  }
}

TEST_F(ConsistencyCommand, WrongUsageIsTold) {
  test::expectFailure(run({"--runs", "0"}), "epcc_consistency", 2, "--runs");
  test::expectFailure(run({"surplus"}), "epcc_consistency", 2, "surplus");
}

}  // namespace
}  // namespace epcc
