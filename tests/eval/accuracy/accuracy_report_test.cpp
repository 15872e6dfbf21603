// SPDX-License-Identifier: BSD-3-Clause
// The tables of the page: which rows they have, what they add up, where they go.
#include "eval/accuracy/accuracy_report.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "epcc_segmentation/parameter_table.h"
#include "eval/accuracy/accuracy_chart.h"
#include "tests/support/expect_errors.h"

namespace epcc::test {
namespace {

FrameRecord record(const std::string& dataset, const std::string& frame, const std::string& method, long correct) {
  FrameRecord record;
  record.dataset = dataset;
  record.frame = frame;
  record.method = method;
  record.measures.paper.surfaces = 4;
  record.measures.paper.clusters = 6;
  record.measures.paper.detected = 3;
  record.measures.segcomp.correct = correct;
  record.measures.segcomp.noise = 7;
  record.ms = 12.0;
  return record;
}

/// Two Kinect frames with a mirrored copy of the first, and one frame of a scene.
AccuracyResult someResult() {
  AccuracyResult result;
  for (const char* method : {kAutoMethod, "epcc"}) {
    const FrameRecord first = record("kinect", "f1", method, 2), second = record("kinect", "f2", method, 3);
    for (const FrameRecord& r :
         {first, second, record("kinect-mirrored", "f1", method, 1), record("a-stereo", "a", method, 4)})
      result.all.add(r);
    result.halves[0].add(first);
    result.halves[1].add(second);
  }
  result.frames = {record("kinect", "f1", kAutoMethod, 2), record("kinect", "f1", "epcc", 1),
                   record("sensors", "l515_a", kAutoMethod, 3)};
  return result;
}

Table tableNamed(const std::string& name, const AccuracyResult& result = someResult()) {
  for (const auto& [table_name, table] : accuracyTables(result))
    if (table_name == name) return table;
  ADD_FAILURE() << "no table " << name;
  return {};
}

using Row = std::vector<std::string>;

TEST(AccuracyTables, TotalsHaveARowForWhatWasRun) {
  const Table table = tableNamed("totals");
  ASSERT_EQ(table.rows.size(), 2U);
  EXPECT_EQ(table.rows[0], (Row{"kinect", kAutoMethod, "2", "8", "1.50", "0.75", "0", "0", "5", "14", "12"}));
  EXPECT_EQ(table.rows[1][1], "epcc");
}

TEST(AccuracyTables, HalvesStandSideBySide) {
  const Table table = tableNamed("halves");
  ASSERT_EQ(table.rows.size(), 2U);
  EXPECT_EQ(table.rows[0], (Row{"kinect", kAutoMethod, "4", "1.50", "0.75", "2", "7", "4", "1.50", "0.75", "3", "7"}));
}

TEST(AccuracyTables, ScenesAddUpCorrectAndNoise) {
  const Table table = tableNamed("scenes");
  ASSERT_EQ(table.rows.size(), 9U);
  EXPECT_EQ(table.rows.back()[2], "4");
  EXPECT_EQ(table.rows.back()[3], "4 (7)");
}

TEST(AccuracyTables, FramesShowMeasuredAndGivenSensorInOneRow) {
  const Table table = tableNamed("frames");
  ASSERT_EQ(table.rows.size(), 2U);
  EXPECT_EQ(table.rows[0], (Row{"kinect", "f1", "4", "2", "0", "0", "0", "7", "1", "7"}));
  EXPECT_EQ(table.rows[1], (Row{"sensors", "l515_a", "4", "3", "0", "0", "0", "7", "-", "-"}));
}

TEST(AccuracyTables, SensorsHaveARowEachAndOneForAll) {
  AccuracyResult result;
  for (const char* sensor : {"Kinect v1", "RealSense L515"})
    for (const char* method : {kAutoMethod, "epcc", "omps"})
      if (sensor != std::string("RealSense L515") || method != std::string("epcc"))
        result.sensors.add(record(sensor, "f", method, method == std::string("omps") ? 1 : 3));
  const Table table = tableNamed("sensors", result);
  ASSERT_EQ(table.rows.size(), 3U);
  EXPECT_EQ(table.columns[3].title, kAutoMethod);
  EXPECT_EQ(table.rows[0], (Row{"Kinect v1", "1", "4", "3 (7)", "3 (7)", "-", "-", "-", "1 (7)"}));
  EXPECT_EQ(table.rows[1], (Row{"RealSense L515", "1", "4", "3 (7)", "-", "-", "-", "-", "1 (7)"}));
  EXPECT_EQ(table.rows[2], (Row{"all", "2", "8", "6 (14)", "-", "-", "-", "-", "2 (14)"}))
      << "a method that was left out somewhere has no sum";
}

TEST(AccuracyTables, FramesThatAMethodFailedOnAreSaid) {
  AccuracyResult result;
  FrameRecord failed = record("kinect", "f2", "ransac", 0);
  failed.measures = {};
  failed.error = "no luck today";
  for (const FrameRecord& r : {record("kinect", "f1", kAutoMethod, 3), record("kinect", "f2", kAutoMethod, 3),
                               record("kinect", "f1", "ransac", 2), failed}) {
    result.all.add(r);
    result.sensors.add(r);
  }
  EXPECT_EQ(tableNamed("sensors", result).rows[0][7], "2 (7), 1 failed");
  EXPECT_EQ(tableNamed("totals", result).rows[1][2], "2, 1 failed");
}

TEST(AccuracyTables, CopiesHaveTheMeanOfThoseWithTheSamePixels) {
  AccuracyResult result;
  long correct = 2;
  for (const char* dataset : {"sensors", "sensors-mirrored", "sensors-flipped", "sensors-turned", "sensors-transposed",
                              "sensors-half", "sensors-holes"})
    result.all.add(record(dataset, "l515_a", kAutoMethod, correct++));
  const Table table = tableNamed("copies", result);
  ASSERT_EQ(table.rows.size(), 8U);
  EXPECT_EQ(table.rows[0], (Row{"sensors", "original", "4", "1.50", "0.75", "2", "7", "-", "-"}));
  EXPECT_EQ(table.rows[4], (Row{"sensors", "transposed", "4", "1.50", "0.75", "6", "7", "-", "-"}));
  EXPECT_EQ(table.rows[5], (Row{"sensors", "mean of these", "4", "1.50", "0.75", "4.0", "7.0", "-", "-"}));
  EXPECT_EQ(table.rows[6][1], "half");
  EXPECT_EQ(table.rows[7], (Row{"sensors", "holes", "4", "1.50", "0.75", "8", "7", "-", "-"}));
}

TEST(AccuracyTables, RepeatabilityOfTheHalvesStandsSideBySide) {
  AccuracyResult result;
  for (long half = 0; half < 2; ++half) {
    RepeatabilityRow row{"sequence", kAutoMethod, 5, {}};
    row.sums.shared = 100;
    row.sums.labelled = 90 + half;
    row.sums.repeated_pixels = 80 + half;
    row.sums.regions = 10;
    row.sums.repeated = 7 + half;
    result.repeatability[static_cast<std::size_t>(half)].rows.push_back(row);
  }
  const Table table = tableNamed("repeatability", result);
  ASSERT_EQ(table.rows.size(), 1U);
  EXPECT_EQ(table.rows[0],
            (Row{kAutoMethod, "5", "0.80", "0.90", "7 of 10", "-", "-", "0.81", "0.91", "8 of 10", "-", "-"}));
}

TEST(AccuracyTables, TheCurveHasAColumnForEachValue) {
  AccuracyResult result;
  long correct = 0;
  for (const double value : accuracyCurve().values) {
    result.curve.add(record("kinect", "f1", curveText(value), ++correct));
    result.curve.add(record("abw", "f1", curveText(value), 2));
  }
  const Table table = tableNamed("curve", result);
  ASSERT_EQ(table.rows.size(), 3U);
  ASSERT_EQ(table.columns.size(), 2 + accuracyCurve().values.size());
  EXPECT_EQ(table.rows[0][0], "kinect");
  EXPECT_EQ(table.rows[0][2], "1 (7)");
  EXPECT_EQ(table.rows[2][3], "4 (14)");
  const auto is_default = [](const TableColumn& column) { return column.title == curveDefault() + ", default"; };
  EXPECT_EQ(std::count_if(table.columns.begin(), table.columns.end(), is_default), 1);
}

TEST(AccuracyCurve, ThePictureHasSharesOfTheSurfaces) {
  ExperimentSummary curve;
  long correct = 9;
  for (const double value : accuracyCurve().values) {
    FrameRecord kinect = record("kinect", "f1", curveText(value), correct++), abw = record("abw", "f1", "", 10);
    kinect.measures.paper.surfaces = abw.measures.paper.surfaces = 20;
    abw.method = kinect.method;
    curve.add(kinect);
    curve.add(abw);
    curve.add(record("icl", "f1", curveText(value), 1));
  }
  const Plot chart = accuracyChart(curve);
  ASSERT_EQ(chart.series.size(), 2U) << "four surfaces give no curve";
  EXPECT_EQ(chart.series[0].name, "kinect");
  ASSERT_EQ(chart.series[0].points.size(), accuracyCurve().values.size());
  EXPECT_EQ(chart.series[0].points[1].y, 0.5);
  EXPECT_EQ(chart.series[0].points[1].x, 0.35);
  EXPECT_EQ(chart.series[0].points.front().text, curveText(accuracyCurve().values.front()));
  EXPECT_EQ(chart.series[0].points.back().text, curveText(accuracyCurve().values.back()));
  EXPECT_EQ(chart.series[0].points[1].text, "");
  EXPECT_EQ(chart.series[1].points.front().text, "") << "the ends are in one place";
  const auto is_large = [](const PlotPoint& point) { return point.large; };
  EXPECT_EQ(std::count_if(chart.series[0].points.begin(), chart.series[0].points.end(), is_large), 1);
}

TEST(AccuracyCurve, ItsValuesAreThoseOfTheParameter) {
  for (const double value : accuracyCurve().values) {
    Parameters parameters;
    EXPECT_EQ(setParameter(std::string(accuracyCurve().parameter) + "=" + curveText(value), parameters), "");
    EXPECT_EQ(parameters.validate(), "") << value;
  }
  EXPECT_EQ(curveMethods().size(), accuracyCurve().values.size());
}

TEST(AccuracySensors, AreNamedAfterTheDataSetOrTheFrame) {
  EXPECT_EQ(sensorOf("kinect", "pcl_capture0001"), "Kinect v1");
  EXPECT_EQ(sensorOf("sensors", "l515_walk_boxes"), "RealSense L515");
  EXPECT_EQ(sensorOf("lidars", "ouster_os1_128_street"), "Ouster OS1-128 lidar");
  EXPECT_EQ(sensorOf("sensors", "zed_kitchen"), "zed") << "not known";
}

TEST(AccuracyTables, StepsCountFramesWithBothSidesCorrect) {
  AccuracyResult result;
  for (const long correct : {2, 1, 2}) result.steps.push_back(record("door-realsense-100", "f", "epcc", correct));
  result.steps.push_back(record("door-realsense-100", "f", kAutoMethod, 1));
  const Table table = tableNamed("steps", result);
  ASSERT_EQ(table.rows.size(), accuracySteps().size());
  int filled = 0;
  for (const Row& row : table.rows) {
    ASSERT_EQ(row.size(), 5U);
    if (row[3] == "0 of 0" && row[4] == "0 of 0") continue;
    EXPECT_EQ(row, (Row{"door", "realsense", "10", "0 of 1", "2 of 3"}));
    ++filled;
  }
  EXPECT_EQ(filled, 1);
}

TEST(AccuracyTables, NothingRunGivesEmptyTables) {
  for (const auto& [name, table] : accuracyTables({})) {
    if (name != "scenes" && name != "steps") {
      EXPECT_TRUE(table.rows.empty()) << name;
    }
  }
}

Table oneCell(const std::string& text) {
  return {{{"x", false}}, {{text}}};
}

const char kPage[] =
    "# Page\n<!-- table one -->\nold\n<!-- end of table -->\nprose\n<!-- table two -->\n<!-- end of table -->\n";

TEST(PageWithTables, ReplacesTablesAndKeepsTheProse) {
  const std::string page = pageWithTables(kPage, {{"one", oneCell("new")}, {"two", oneCell("more")}}, "p.md");
  EXPECT_EQ(page.find("old"), std::string::npos);
  EXPECT_NE(page.find("| new |"), std::string::npos);
  EXPECT_LT(page.find("prose"), page.find("| more |"));
  EXPECT_EQ(pageWithTables(page, {{"one", oneCell("new")}, {"two", oneCell("more")}}, "p.md"), page);
}

TEST(PageWithTables, AMissingPlaceOrEndIsAnError) {
  expectInputError([] { pageWithTables(kPage, {{"three", oneCell("x")}}, "p.md"); }, "p.md", "three", "no line");
  const std::string open = "<!-- table one -->\n<!-- table two -->\n<!-- end of table -->\n";
  expectInputError([&] { pageWithTables(open, {{"one", oneCell("x")}}, "p.md"); }, "p.md", "one", "end of table");
}

}  // namespace
}  // namespace epcc::test
