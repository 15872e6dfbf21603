// SPDX-License-Identifier: BSD-3-Clause
// Sums, medians, totals, and their tables.
#include "eval/experiment/experiment_summary.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <vector>

#include "datasets/support/quantile.h"
#include "eval/experiment/time_counts.h"
#include "eval/program/progress_line.h"
#include "eval/report/evaluation_report.h"

namespace {

using namespace epcc;

/// Every count differs, so that none can stand for another.
FrameRecord record(const std::string& dataset, const std::string& method, std::optional<double> ms, long unit = 1) {
  FrameRecord result{dataset, "frame", method, {}, ms, ""};
  result.measures.paper = {10 * unit, 12 * unit, 9 * unit, 2 * unit, 3 * unit};
  result.measures.segcomp = {7 * unit, 1 * unit, 4 * unit, 5 * unit, 6 * unit};
  result.measures.instances = {10 * unit, 12 * unit, 8 * unit, 7200000 * unit, 7600000 * unit, 1000 * unit, 900 * unit};
  result.measures.planes = {2 * unit, 3000000 * unit, 10000 * unit};
  return result;
}

FrameRecord failure(const std::string& dataset, const std::string& method) {
  return {dataset, "bad, frame", method, {}, {}, "file: is \"broken\""};
}

TEST(ExperimentSummary, SumsByDataSetAndMethodInTheOrderSeen) {
  ExperimentSummary summary;
  for (const auto& r : {record("z", "m2", 1.0), record("z", "m1", 1.0), record("a", "m2", 1.0), record("z", "m2", 3.0)})
    summary.add(r);
  ASSERT_EQ(summary.rows().size(), 3U);
  EXPECT_EQ(summary.rows()[0].dataset + summary.rows()[0].method, "zm2");
  EXPECT_EQ(summary.rows()[1].dataset + summary.rows()[1].method, "zm1");
  EXPECT_EQ(summary.rows()[2].dataset + summary.rows()[2].method, "am2");
  EXPECT_EQ(summary.rows()[0].frames, 2);
  EXPECT_EQ(summary.rows()[0].measures.paper.surfaces, 20);
  EXPECT_EQ(summary.scored(), 4);
}

TEST(ExperimentSummary, ErrorsAreCountedAndAddNothing) {
  ExperimentSummary summary;
  summary.add(record("a", "m", 5.0));
  summary.add(failure("a", "m"));
  EXPECT_EQ(summary.rows()[0].frames, 2);
  EXPECT_EQ(summary.rows()[0].errors, 1);
  EXPECT_EQ(summary.rows()[0].measures.paper.surfaces, 10);
  EXPECT_EQ(summary.rows()[0].medianMs(), 5.0);
  EXPECT_EQ(summary.errors(), 1);
  EXPECT_EQ(summary.scored(), 1);
}

// epcc_eval counts times by value, epcc_compare keeps them all: what both call median_ms must be the same.
TEST(ExperimentSummary, MedianIsThatOfAllTheTimes) {
  std::vector<double> times;
  TimeCounts counts;
  for (const double ms : {9.0, 1.0, 4.0, 100.0, 4.001, 4.0, 0.25}) {
    times.push_back(ms);
    counts.add(ms);
    EXPECT_NEAR(counts.medianMs().value(), median(times), 1e-9) << times.size();
  }
}

TEST(ExperimentSummary, Median) {
  ExperimentSummary summary;
  EXPECT_FALSE(SummaryRow().medianMs().has_value());
  for (const double ms : {9.0, 1.0, 4.0}) summary.add(record("a", "m", ms));
  EXPECT_EQ(summary.rows()[0].medianMs(), 4.0);
  summary.add(record("a", "m", 100.0));
  EXPECT_EQ(summary.rows()[0].medianMs(), 6.5);
  summary.add(record("a", "imported", std::nullopt));
  EXPECT_FALSE(summary.rows()[1].medianMs().has_value());
}

TEST(ExperimentSummary, TotalsOverTheDataSets) {
  ExperimentSummary summary;
  summary.add(record("a", "m", 1.0));
  summary.add(record("b", "m", 3.0, 100));
  summary.add(failure("b", "n"));
  const auto totals = summary.totals();
  ASSERT_EQ(totals.size(), 2U);
  EXPECT_EQ(totals[0].dataset, "all");
  EXPECT_EQ(totals[0].measures.segcomp.noise, 606);
  EXPECT_EQ(totals[0].medianMs(), 2.0);
  EXPECT_EQ(totals[1].errors, 1);
}

TEST(EvaluationReport, SummaryJsonHasTheContractsKeysInOrder) {
  ExperimentSummary summary;
  summary.add(record("a", "m", 2.5));
  summary.add(failure("a", "m"));
  const auto json = nlohmann::ordered_json::parse(summaryJson(summary.rows()));
  EXPECT_EQ(json.dump(),
            R"({"version":1,"rows":[{"dataset":"a","method":"m","frames":2,"errors":1,"N":10,"IC":12,"D":9,"No":2,)"
            R"("Nu":3,"correct":7,"over":1,"under":4,"missed":5,"noise":6,"median_ms":2.5}]})");
}

TEST(EvaluationReport, UnknownTimeIsNull) {
  ExperimentSummary summary;
  summary.add(record("a", "m", std::nullopt));
  EXPECT_TRUE(nlohmann::json::parse(summaryJson(summary.rows())).at("rows").at(0).at("median_ms").is_null());
}

TEST(EvaluationReport, FramesTable) {
  Table table = emptyFramesTable();
  addFrameRow(record("a", "m", 2.5), table);
  addFrameRow(failure("a", "m"), table);
  EXPECT_EQ(csvTable(table),
            "dataset,frame,method,frames,errors,N,IC,D,No,Nu,correct,over,under,missed,noise,median_ms,error,matched,"
            "iou_sum_millionths,dice_sum_millionths,plane_pixels,dominated_pixels,compared_planes,"
            "normal_error_sum_microdegrees,offset_error_sum_micrometres\n"
            "a,frame,m,1,0,10,12,9,2,3,7,1,4,5,6,2.500,,8,7200000,7600000,1000,900,2,3000000,10000\n"
            "a,\"bad, frame\",m,1,1,0,0,0,0,0,0,0,0,0,0,,\"file: is \"\"broken\"\"\",0,0,0,0,0,0,0,0\n");
}

TEST(EvaluationReport, Rates) {
  ExperimentSummary summary;
  summary.add(record("a", "m", 2.5));
  summary.add(record("a", "m", 2.5));
  const Table table = ratesTable(summary.rows());
  EXPECT_EQ(csvTable(table),
            "dataset,method,N/frame,IC/frame,D/N,No/N,Nu/N,correct/N,precision,recall,IoU,Dice,pixels,normal deg,"
            "offset mm\n"
            "a,m,10.0,12.0,0.900,0.200,0.300,0.700,0.667,0.800,0.900,0.950,0.900,1.50,5.0\n");
}

TEST(EvaluationReport, NothingScoredHasNoRates) {
  ExperimentSummary summary;
  summary.add(failure("a", "m"));
  EXPECT_EQ(ratesTable(summary.rows()).rows[0],
            (std::vector<std::string>{"a", "m", "-", "-", "-", "-", "-", "-", "-", "-", "-", "-", "-", "-", "-"}));
}

TEST(EvaluationReport, MarkdownNamesTheErrorsAndTotalsSeveralDataSets) {
  ExperimentSummary summary;
  summary.add(record("a", "m", 2.5));
  const std::string one = summaryMarkdown(summary, {});
  EXPECT_EQ(one.find("| all |"), std::string::npos);
  EXPECT_EQ(one.find("| error |"), std::string::npos);
  summary.add(record("b", "m", 2.5));
  const std::string two = summaryMarkdown(summary, {"b/x: file: is gone"});
  EXPECT_NE(two.find("| all | m | 2 | 0 | 20 |"), std::string::npos) << two;
  EXPECT_NE(two.find("| b/x: file: is gone |"), std::string::npos) << two;
}

TEST(ProgressLine, SaysHowFarHowFastHowLong) {
  EXPECT_EQ(progressText(0, 300, 1.0), "0/300 frames");
  EXPECT_EQ(progressText(12, 300, 3.0), "12/300 frames, 4 per second, 1:12 left");
  EXPECT_EQ(progressText(1, 7201, 1.0), "1/7201 frames, 1 per second, 2:00:00 left");
}

}  // namespace
