// SPDX-License-Identifier: BSD-3-Clause
// Picks the rows of each table from the summaries; puts tables into the page.
#include "eval/accuracy/accuracy_report.h"

#include <algorithm>

#include "datasets/rendered/scene.h"
#include "datasets/sources/frame_copies.h"
#include "datasets/support/input_error.h"
#include "eval/report/repeatability_table.h"

namespace epcc {

namespace {

using Cells = std::vector<std::string>;
using Names = std::vector<std::string>;

/// Sum over data sets of one method; those that were not run add nothing.
SummaryRow sumOf(const ExperimentSummary& summary, const Names& datasets, const std::string& method) {
  SummaryRow sum{{}, method, 0, 0, {}, {}};
  for (const SummaryRow& row : summary.rows())
    if (row.method == method && std::find(datasets.begin(), datasets.end(), row.dataset) != datasets.end()) sum += row;
  return sum;
}

std::string count(long value) {
  return std::to_string(value);
}

std::string ratio(long part, long whole) {
  return whole > 0 ? numberCell(static_cast<double>(part) / static_cast<double>(whole), 2) : "-";
}

void append(Cells& cells, const Cells& more) {
  cells.insert(cells.end(), more.begin(), more.end());
}

Table tableOf(const Names& left, const Names& right) {
  Table table;
  for (const std::string& title : left) table.columns.push_back({title, false});
  for (const std::string& title : right) table.columns.push_back({title, true});
  return table;
}

/// ", 1 failed": frames that a method could not do, which add to no number.
std::string failedFrames(const SummaryRow& row) {
  return row.errors > 0 ? ", " + count(row.errors) + " failed" : "";
}

Table totalsTable(const ExperimentSummary& all) {
  Table table = tableOf({"data", "method"}, {"frames", "N", "IC/N", "D/N", "N_o", "N_u", "correct", "noise", "ms"});
  for (const std::string& dataset : accuracyDatasets())
    for (const std::string& method : accuracyMethods()) {
      const SummaryRow row = sumOf(all, {dataset}, method);
      if (row.frames == 0) continue;
      const PaperMeasures& paper = row.measures.paper;
      const auto ms = row.medianMs();
      table.rows.push_back({dataset, method, count(row.frames) + failedFrames(row), count(paper.surfaces),
                            ratio(paper.clusters, paper.surfaces), ratio(paper.detected, paper.surfaces),
                            count(paper.over_segmented), count(paper.under_segmented),
                            count(row.measures.segcomp.correct), count(row.measures.segcomp.noise),
                            ms ? numberCell(*ms, 0) : "-"});
    }
  return table;
}

/// N, IC/N, D/N, correct, noise.
Cells shortCells(const SummaryRow& row) {
  const PaperMeasures& paper = row.measures.paper;
  return {count(paper.surfaces), ratio(paper.clusters, paper.surfaces), ratio(paper.detected, paper.surfaces),
          count(row.measures.segcomp.correct), count(row.measures.segcomp.noise)};
}

/// "12 (3)": correct and, in brackets, noise; "-" for what was not run.
std::string correctAndNoise(const SummaryRow& row) {
  const SegcompMeasures& segcomp = row.measures.segcomp;
  if (row.frames == 0) return "-";
  return count(segcomp.correct) + " (" + count(segcomp.noise) + ")" + failedFrames(row);
}

/// The data sets of a summary in the order in which they came.
Names datasetsOf(const ExperimentSummary& summary) {
  Names names;
  for (const SummaryRow& row : summary.rows())
    if (std::find(names.begin(), names.end(), row.dataset) == names.end()) names.push_back(row.dataset);
  return names;
}

Table sensorsTable(const ExperimentSummary& sensors) {
  Table table = tableOf({"sensor"}, {"frames", "N"});
  for (const std::string& method : accuracyMethods()) table.columns.push_back({method, true});
  const auto add = [&](const std::string& name, const Names& datasets) {
    const SummaryRow measured = sumOf(sensors, datasets, kAutoMethod);
    Cells cells = {name, count(measured.frames), count(measured.measures.paper.surfaces)};
    for (const std::string& method : accuracyMethods()) {
      const SummaryRow row = sumOf(sensors, datasets, method);
      cells.push_back(row.frames == measured.frames ? correctAndNoise(row) : "-");
    }
    table.rows.push_back(cells);
  };
  for (const std::string& name : datasetsOf(sensors)) add(name, {name});
  if (!table.rows.empty()) add("all", datasetsOf(sensors));
  return table;
}

Table halvesTable(const AccuracyResult& result) {
  Table table = tableOf({"data", "method"}, {"even N", "IC/N", "D/N", "correct", "noise"});
  for (const char* title : {"odd N", "IC/N", "D/N", "correct", "noise"}) table.columns.push_back({title, true});
  for (const std::string& dataset : accuracyDatasets())
    for (const char* method : {kAutoMethod, "epcc"}) {
      const SummaryRow even = sumOf(result.halves[0], {dataset}, method);
      const SummaryRow odd = sumOf(result.halves[1], {dataset}, method);
      if (odd.frames == 0) continue;  // a single frame has no halves
      Cells cells = {dataset, method};
      append(cells, shortCells(even));
      append(cells, shortCells(odd));
      table.rows.push_back(cells);
    }
  return table;
}

/// What is correct and what is noise, of one of so many copies on average.
Cells meanCells(const SummaryRow& row, std::size_t copies) {
  if (row.frames == 0) return {"-", "-"};
  const SegcompMeasures& segcomp = row.measures.segcomp;
  const int digits = copies > 1 ? 1 : 0;
  const auto mean = [&](long sum) {
    return numberCell(static_cast<double>(sum) / static_cast<double>(copies), digits);
  };
  return {mean(segcomp.correct), mean(segcomp.noise)};
}

/// A row of one copy, or of several together.
Cells copyRow(const ExperimentSummary& all, const std::string& dataset, const std::string& name, const Names& sources) {
  const SummaryRow measured = sumOf(all, sources, kAutoMethod);
  const PaperMeasures& paper = measured.measures.paper;
  Cells cells = {dataset, name, count(paper.surfaces / static_cast<long>(sources.size())),
                 ratio(paper.clusters, paper.surfaces), ratio(paper.detected, paper.surfaces)};
  append(cells, meanCells(measured, sources.size()));
  append(cells, meanCells(sumOf(all, sources, "epcc"), sources.size()));
  return cells;
}

Table copiesTable(const ExperimentSummary& all) {
  Table table = tableOf({"data", "copy"}, {"N", "IC/N", "D/N", "correct", "noise", "preset correct", "preset noise"});
  for (const std::string& dataset : accuracyDatasets()) {
    const auto source = [&](FrameCopy copy) { return dataset + "-" + copyName(copy); };
    if (sumOf(all, {source(frameCopies().back())}, kAutoMethod).frames == 0) continue;
    Names same = {dataset};
    table.rows.push_back(copyRow(all, dataset, "original", same));
    for (const bool same_pixels : {true, false}) {
      for (const FrameCopy copy : frameCopies()) {
        if (hasSamePixels(copy) != same_pixels) continue;
        table.rows.push_back(copyRow(all, dataset, copyName(copy), {source(copy)}));
        if (same_pixels) same.push_back(source(copy));
      }
      if (same_pixels) table.rows.push_back(copyRow(all, dataset, "mean of these", same));
    }
  }
  return table;
}

Table repeatabilityTableOf(const std::array<SequenceResult, 2>& halves) {
  Table table = tableOf({"method"}, {"lag"});
  for (const char* half : {"1st half: ", "2nd half: "})
    for (const char* title : {"pixels", "labelled", "regions repeated", "angle deg", "offset mm"})
      table.columns.push_back({std::string(title == std::string("pixels") ? half : "") + title, true});
  for (std::size_t row = 0; row < halves[0].rows.size() && row < halves[1].rows.size(); ++row) {
    Cells cells = {halves[0].rows[row].method, count(halves[0].rows[row].lag)};
    for (const SequenceResult& half : halves) append(cells, repeatabilityCells(half.rows[row].sums));
    table.rows.push_back(cells);
  }
  return table;
}

Table curveTable(const ExperimentSummary& curve) {
  Table table = tableOf({"data"}, {"N"});
  for (const double value : accuracyCurve().values) {
    const std::string text = curveText(value);
    table.columns.push_back({text == curveDefault() ? text + ", default" : text, true});
  }
  const auto add = [&](const std::string& name, const Names& datasets) {
    Cells cells = {name, count(sumOf(curve, datasets, curveDefault()).measures.paper.surfaces)};
    for (const double value : accuracyCurve().values)
      cells.push_back(correctAndNoise(sumOf(curve, datasets, curveText(value))));
    table.rows.push_back(cells);
  };
  Names every;
  for (const std::string& dataset : accuracyDatasets()) {
    if (sumOf(curve, {dataset}, curveDefault()).frames == 0) continue;
    add(dataset, {dataset});
    every.push_back(dataset);
  }
  if (!every.empty()) add("all", every);
  return table;
}

Table scenesTable(const ExperimentSummary& all) {
  Table table = tableOf({"noise", "scene"}, {"N"});
  for (const std::string& method : accuracyMethods()) table.columns.push_back({method, true});
  const auto add = [&](const std::string& noise, const std::string& scene, const Names& datasets) {
    Cells cells = {noise, scene, count(sumOf(all, datasets, kAutoMethod).measures.paper.surfaces)};
    for (const std::string& method : accuracyMethods()) {
      const SegcompMeasures sum = sumOf(all, datasets, method).measures.segcomp;
      cells.push_back(count(sum.correct) + " (" + count(sum.noise) + ")");
    }
    table.rows.push_back(cells);
  };
  Names every;
  for (const std::string& noise : accuracyNoises())
    for (const std::string& scene : sceneNames()) {
      every.push_back(sceneDataset(scene, noise));
      add(noise, scene, {every.back()});
    }
  add("both", "all", every);
  return table;
}

/// "4 of 5": frames on which wall and second plane are both correct.
std::string separateFrames(const std::vector<FrameRecord>& records, const std::string& dataset,
                           const std::string& method) {
  long frames = 0, separate = 0;
  for (const FrameRecord& record : records) {
    if (record.dataset != dataset || record.method != method) continue;
    ++frames;
    separate += record.measures.segcomp.correct == 2 ? 1 : 0;
  }
  return count(separate) + " of " + count(frames);
}

Table stepsTable(const std::vector<FrameRecord>& records) {
  Table table = tableOf({"what", "sensor"}, {"step cm", kAutoMethod, "epcc"});
  for (const AccuracyStep& step : accuracySteps())
    table.rows.push_back({step.scene, step.sensor, numberCell(100.0 * step.metres, 0),
                          separateFrames(records, stepDataset(step), kAutoMethod),
                          separateFrames(records, stepDataset(step), "epcc")});
  return table;
}

/// The row of a frame with the sensor measured stands before the one with the preset, if there is one.
Table framesTable(const std::vector<FrameRecord>& records) {
  Table table = tableOf({"data", "frame"}, {"N", "correct", "over", "under", "missed", "noise"});
  for (const char* title : {"preset correct", "preset noise"}) table.columns.push_back({title, true});
  for (const FrameRecord& record : records) {
    const SegcompMeasures& segcomp = record.measures.segcomp;
    if (record.method != kAutoMethod) {
      Cells& row = table.rows.back();
      row[row.size() - 2] = count(segcomp.correct);
      row[row.size() - 1] = count(segcomp.noise);
      continue;
    }
    table.rows.push_back({record.dataset, record.frame, count(record.measures.paper.surfaces), count(segcomp.correct),
                          count(segcomp.over), count(segcomp.under), count(segcomp.missed), count(segcomp.noise), "-",
                          "-"});
  }
  return table;
}

}  // namespace

std::vector<NamedTable> accuracyTables(const AccuracyResult& result) {
  return {{"sensors", sensorsTable(result.sensors)},
          {"totals", totalsTable(result.all)},
          {"halves", halvesTable(result)},
          {"copies", copiesTable(result.all)},
          {"repeatability", repeatabilityTableOf(result.repeatability)},
          {"curve", curveTable(result.curve)},
          {"scenes", scenesTable(result.all)},
          {"steps", stepsTable(result.steps)},
          {"frames", framesTable(result.frames)}};
}

std::string pageWithTables(const std::string& page, const std::vector<NamedTable>& tables, const std::string& file) {
  const std::string end_mark = "<!-- end of table -->";
  std::string text = page;
  for (const auto& [name, table] : tables) {
    const std::string mark = "<!-- table " + name + " -->\n";
    const std::size_t start = text.find(mark);
    if (start == std::string::npos) throw InputError(file, name, "there is no line <!-- table " + name + " -->");
    const std::size_t from = start + mark.size();
    const std::size_t end = text.find(end_mark, from);
    const std::size_t next = text.find("<!-- table ", from);
    if (end == std::string::npos || next < end) throw InputError(file, name, "the table's place has no " + end_mark);
    text.replace(from, end - from, "\n" + markdownTable(table) + "\n");
  }
  return text;
}

}  // namespace epcc
