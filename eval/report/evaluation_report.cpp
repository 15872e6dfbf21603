// SPDX-License-Identifier: BSD-3-Clause
// Numbers of the summary as JSON and as tables.
#include "eval/report/evaluation_report.h"

#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "eval/measures/measure_fields.h"

namespace epcc {

namespace {

constexpr double kNotKnown = std::numeric_limits<double>::quiet_NaN();

using Counts = std::vector<std::pair<const char*, long>>;

/// The counts of summary.json in its order.
Counts countsOf(long frames, long errors, const FrameMeasures& measures) {
  Counts counts = {{"frames", frames}, {"errors", errors}};
  for (const MeasureField& field : countFields()) counts.emplace_back(field.name, field.value(measures));
  return counts;
}

Counts furtherCounts(const FrameMeasures& measures) {
  Counts counts;
  for (const MeasureField& field : furtherFields()) counts.emplace_back(field.name, field.value(measures));
  return counts;
}

void addTitles(const Counts& counts, Table& table) {
  for (const auto& count : counts) table.columns.push_back({count.first, true});
}

void addCells(const Counts& counts, std::vector<std::string>& cells) {
  for (const auto& count : counts) cells.push_back(std::to_string(count.second));
}

std::string milliseconds(const std::optional<double>& ms, const std::string& missing) {
  return numberCell(ms.value_or(kNotKnown), 3, missing);
}

double per(long count, long whole) {
  return whole > 0 ? static_cast<double>(count) / static_cast<double>(whole) : kNotKnown;
}

std::vector<std::string> ratesOf(const SummaryRow& row) {
  const PaperMeasures& paper = row.measures.paper;
  const InstanceMeasures& instances = row.measures.instances;
  const auto share = [](double value) { return numberCell(value, 3, "-"); };
  return {row.dataset,
          row.method,
          numberCell(per(paper.surfaces, row.frames - row.errors), 1, "-"),
          numberCell(per(paper.clusters, row.frames - row.errors), 1, "-"),
          share(per(paper.detected, paper.surfaces)),
          share(per(paper.over_segmented, paper.surfaces)),
          share(per(paper.under_segmented, paper.surfaces)),
          share(per(row.measures.segcomp.correct, paper.surfaces)),
          share(instances.precision()),
          share(instances.recall()),
          share(instances.meanIou()),
          share(instances.meanDice()),
          share(instances.coverage()),
          numberCell(row.measures.planes.meanNormalDegrees(), 2, "-"),
          numberCell(1e3 * row.measures.planes.meanOffsetMetres(), 1, "-")};
}

std::vector<std::string> frameCells(const FrameRecord& record) {
  std::vector<std::string> cells = {record.dataset, record.frame, record.method};
  addCells(countsOf(1, record.error.empty() ? 0 : 1, record.measures), cells);
  cells.push_back(milliseconds(record.ms, ""));
  cells.push_back(record.error);
  addCells(furtherCounts(record.measures), cells);
  return cells;
}

nlohmann::ordered_json jsonRows(const std::vector<SummaryRow>& rows) {
  auto json = nlohmann::ordered_json::array();
  for (const SummaryRow& row : rows) {
    nlohmann::ordered_json entry = {{"dataset", row.dataset}, {"method", row.method}};
    for (const auto& [name, count] : countsOf(row.frames, row.errors, row.measures)) entry[name] = count;
    const std::optional<double> ms = row.medianMs();
    entry["median_ms"] = ms ? nlohmann::ordered_json(*ms) : nlohmann::ordered_json(nullptr);
    json.push_back(entry);
  }
  return json;
}

/// As a table of one column below others; nothing without lines.
std::string linesTable(const char* title, const std::vector<std::string>& lines) {
  if (lines.empty()) return {};
  Table table;
  table.columns = {{title, false}};
  for (const std::string& line : lines) table.rows.push_back({line});
  return "\n" + markdownTable(table);
}

}  // namespace

std::vector<SummaryRow> withTotals(const ExperimentSummary& summary) {
  std::vector<SummaryRow> rows = summary.rows();
  std::set<std::string> datasets;
  for (const SummaryRow& row : rows) datasets.insert(row.dataset);
  const std::vector<SummaryRow> totals = summary.totals();
  if (datasets.size() > 1) rows.insert(rows.end(), totals.begin(), totals.end());
  return rows;
}

std::string summaryJson(const std::vector<SummaryRow>& rows, const std::vector<SummaryRow>& totals,
                        const DoubtfulFrames& doubtful) {
  nlohmann::ordered_json json = {{"version", 1}, {"rows", jsonRows(rows)}};
  if (!totals.empty()) json["totals"] = jsonRows(totals);
  for (const DoubtfulFrames::OfDataset& of : doubtful.all())
    json["doubtful"].push_back(
        {{"dataset", of.dataset}, {"frames", of.frames}, {"first", of.first}, {"doubt", of.doubt}});
  return json.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

Table countsTable(const std::vector<SummaryRow>& rows) {
  Table table;
  table.columns = {{"dataset", false}, {"method", false}};
  addTitles(countsOf(0, 0, {}), table);
  table.columns.push_back({"median_ms", true});
  for (const SummaryRow& row : rows) {
    std::vector<std::string> cells = {row.dataset, row.method};
    addCells(countsOf(row.frames, row.errors, row.measures), cells);
    cells.push_back(numberCell(row.medianMs().value_or(kNotKnown), 1, "-"));
    table.rows.push_back(cells);
  }
  return table;
}

Table ratesTable(const std::vector<SummaryRow>& rows) {
  Table table;
  table.columns = {{"dataset", false}, {"method", false}};
  for (const char* title : {"N/frame", "IC/frame", "D/N", "No/N", "Nu/N", "correct/N", "precision", "recall", "IoU",
                            "Dice", "pixels", "normal deg", "offset mm"})
    table.columns.push_back({title, true});
  for (const SummaryRow& row : rows) table.rows.push_back(ratesOf(row));
  return table;
}

Table emptyFramesTable() {
  Table table;
  table.columns = {{"dataset", false}, {"frame", false}, {"method", false}};
  addTitles(countsOf(0, 0, {}), table);
  table.columns.push_back({"median_ms", true});
  table.columns.push_back({"error", false});
  addTitles(furtherCounts({}), table);
  return table;
}

void addFrameRow(const FrameRecord& record, Table& table) {
  table.rows.push_back(frameCells(record));
}

std::string frameLine(const FrameRecord& record) {
  return csvLine(frameCells(record));
}

std::vector<TableColumn> pageColumns() {
  std::vector<TableColumn> columns = {{"dataset", false}, {"frame", false}, {"method", false}};
  for (const MeasureField& field : countFields()) columns.push_back({field.name, true});
  columns.push_back({"median_ms", true});
  columns.push_back({"error", false});
  return columns;
}

std::vector<std::string> pageCells(const FrameRecord& record) {
  std::vector<std::string> cells = {record.dataset, record.frame, record.method};
  for (const MeasureField& field : countFields())
    cells.push_back(record.error.empty() ? std::to_string(field.value(record.measures)) : "-");
  cells.push_back(milliseconds(record.ms, "-"));
  cells.push_back(record.error);
  return cells;
}

std::string summaryLatex(const ExperimentSummary& summary) {
  const std::vector<SummaryRow> rows = withTotals(summary);
  return "% Counts, summed over the frames without an error.\n" + latexTable(countsTable(rows)) + "\n% Shares.\n" +
         latexTable(ratesTable(rows));
}

std::string summaryMarkdown(const ExperimentSummary& summary, const std::vector<std::string>& problems,
                            const std::vector<std::string>& doubts) {
  const std::vector<SummaryRow> rows = withTotals(summary);
  std::string text = "# Evaluation\n\nCounts, summed over the frames without an error; median_ms: time of a frame.\n\n";
  text += markdownTable(countsTable(rows));
  text += "\nShares; pixels: share of the planes' pixels in a cluster of their surface.\n\n";
  text += markdownTable(ratesTable(rows));
  return text + linesTable("error", problems) + linesTable("doubt", doubts);
}

std::string summaryText(const ExperimentSummary& summary) {
  const std::vector<SummaryRow> rows = withTotals(summary);
  return textTable(countsTable(rows)) + "\n" + textTable(ratesTable(rows));
}

}  // namespace epcc
