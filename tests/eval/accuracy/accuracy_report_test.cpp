// SPDX-License-Identifier: BSD-3-Clause
// The tables of the page: which rows they have, what they add up, where they go.
#include "eval/accuracy/accuracy_report.h"

#include <gtest/gtest.h>

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
  for (const char* method : {"epcc", kAutoMethod}) {
    const FrameRecord first = record("kinect", "f1", method, 2), second = record("kinect", "f2", method, 3);
    for (const FrameRecord& r :
         {first, second, record("kinect-mirrored", "f1", method, 1), record("a-stereo", "a", method, 4)})
      result.all.add(r);
    result.halves[0].add(first);
    result.halves[1].add(second);
  }
  result.frames = {record("kinect", "f1", "epcc", 2), record("kinect", "f1", kAutoMethod, 1)};
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
  EXPECT_EQ(table.rows[0], (Row{"kinect", "epcc", "2", "8", "1.50", "0.75", "0", "0", "5", "14", "12"}));
  EXPECT_EQ(table.rows[1][1], kAutoMethod);
}

TEST(AccuracyTables, HalvesStandSideBySide) {
  const Table table = tableNamed("halves");
  ASSERT_EQ(table.rows.size(), 2U);
  EXPECT_EQ(table.rows[0], (Row{"kinect", "epcc", "4", "1.50", "0.75", "2", "7", "4", "1.50", "0.75", "3", "7"}));
}

TEST(AccuracyTables, ScenesAddUpCorrectAndNoise) {
  const Table table = tableNamed("scenes");
  ASSERT_EQ(table.rows.size(), 9U);
  EXPECT_EQ(table.rows.back()[2], "4");
  EXPECT_EQ(table.rows.back()[3], "4 (7)");
}

TEST(AccuracyTables, FramesShowGivenAndMeasuredSensorInOneRow) {
  const Table table = tableNamed("frames");
  ASSERT_EQ(table.rows.size(), 1U);
  EXPECT_EQ(table.rows[0], (Row{"kinect", "f1", "4", "2", "0", "0", "0", "7", "1", "7"}));
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
    EXPECT_EQ(row, (Row{"door", "realsense", "10", "2 of 3", "0 of 1"}));
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
