// SPDX-License-Identifier: BSD-3-Clause
// The page is put together section by section, from top to bottom.
#include "eval/batch/html_report.h"

#include <map>

#include "datasets/support/joined.h"
#include "eval/report/evaluation_report.h"
#include "eval/report/html_page.h"

namespace epcc {

namespace {

std::string entry(const char* name, const std::string& text) {
  return std::string("<dt>") + name + "</dt><dd>" + escapeHtml(text) + "</dd>\n";
}

std::string aboutSection(const RunDescription& run, const ExperimentSummary& summary) {
  std::vector<std::string> datasets;
  for (const RunDataset& dataset : run.datasets)
    datasets.push_back(dataset.name + " (" + std::to_string(dataset.frames) + " frames)");
  std::string text = "<dl>\n" + entry("Data sets", joined(datasets)) + entry("Methods", joined(run.methods)) +
                     entry("Noise", run.noise.empty() ? "the frames' own" : run.noise);
  if (run.shard.count > 1) text += entry("Shard", run.shard.text());
  text += entry("Scored", std::to_string(summary.scored()) + " results of a method on a frame, " +
                              std::to_string(summary.errors()) + " errors");
  return text + entry("Made by", "epcc_eval " + run.program) + "</dl>\n";
}

std::string totalsSection(const ExperimentSummary& summary) {
  const std::vector<SummaryRow> rows = withTotals(summary);
  return "<h2>Counts</h2>\n<p>Summed over the frames without an error. N surfaces, IC clusters; D detected, No over- "
         "and "
         "Nu under-segmented surfaces (the paper's measures); correct to noise: SegComp at 80 %; median_ms: time of a "
         "frame. A heading sorts.</p>\n" +
         htmlTable(countsTable(rows)) +
         "<h2>Shares</h2>\n<p>pixels: share of the planes' pixels in a cluster of their surface.</p>\n" +
         htmlTable(ratesTable(rows));
}

std::string figure(const std::string& picture, const std::string& caption) {
  return "<figure>" + (picture.empty() ? "<div class=\"none\"></div>" : picture) + "<figcaption>" +
         escapeHtml(caption) + "</figcaption></figure>\n";
}

std::string methodCaption(const FrameRecord& record) {
  if (!record.error.empty()) return record.method + ": " + record.error;
  const FrameMeasures& m = record.measures;
  return record.method + ": " + std::to_string(m.segcomp.correct) + " of " + std::to_string(m.paper.surfaces) +
         " correct, " + std::to_string(m.paper.clusters) + " clusters";
}

std::string pictureSection(const std::vector<PicturedFrame>& pictures) {
  if (pictures.empty()) return "";
  std::string text =
      "<h2>Frames</h2>\n<p>The first of each data set, and those the first method did worst and best on, by "
      "2 correct / (N + IC).</p>\n";
  for (const PicturedFrame& pictured : pictures) {
    const std::vector<FrameRecord>& records = pictured.frame.records;
    const std::string name = records.at(0).dataset + " / " + records[0].frame;
    text += "<h3>" + escapeHtml(name + " (" + pictured.why + ")") + "</h3>\n<div class=\"frames\">\n";
    text += figure(htmlPicture(picturePath(pictured, 0), name + ", depth"), "depth");
    text += figure(htmlPicture(picturePath(pictured, 1), name + ", truth"), "truth");
    for (std::size_t m = 0; m < records.size(); ++m) {
      // A picture of an earlier, finished attempt may lie beside an error.
      const std::string path = picturePath(pictured, 2 + m);
      const bool done = records[m].error.empty();
      text += figure(done ? htmlPicture(path, name + ", " + records[m].method) : "", methodCaption(records[m]));
    }
    text += "</div>\n";
  }
  return text;
}

std::string rowsSection(const WorstRows& rows) {
  const Table table = rows.table();
  const std::string note = rows.count() == table.rows.size()
                               ? std::string()
                               : "<p>The " + std::to_string(table.rows.size()) + " worst of " +
                                     std::to_string(rows.count()) + " rows; all are in frames.csv.</p>\n";
  return "<h2>Frame by frame</h2>\n" + note + "<div><input type=\"search\" placeholder=\"rows with these words\">\n" +
         htmlTable(table) + "</div>\n";
}

std::string listSection(const std::string& title, const std::vector<std::string>& lines) {
  if (lines.empty()) return "";
  std::string text = "<h2>" + title + "</h2>\n<ul>\n";
  for (const std::string& line : lines) text += "<li>" + escapeHtml(line) + "</li>\n";
  return text + "</ul>\n";
}

}  // namespace

void WorstRows::add(const FrameRecord& record) {
  FrameScore score(record.measures);
  if (!record.error.empty()) score.part = -1;  // before everything that has a score
  rows_.add({score, count_++}, pageCells(record));
}

Table WorstRows::table() const {
  Table table;
  table.columns = pageColumns();
  std::map<std::size_t, const std::vector<std::string>*> in_order;
  for (const auto& [key, cells] : rows_.kept()) in_order[key.second] = &cells;
  for (const auto& [position, cells] : in_order) table.rows.push_back(*cells);
  return table;
}

std::string htmlReport(const RunDescription& run, const ExperimentSummary& summary, const WorstRows& rows,
                       const std::vector<PicturedFrame>& pictures, const std::vector<std::string>& problems,
                       const std::vector<std::string>& doubts) {
  return htmlHead("Plane segmentation, scored") + aboutSection(run, summary) + totalsSection(summary) +
         listSection("Errors", problems) + listSection("Doubts", doubts) + pictureSection(pictures) +
         rowsSection(rows) + htmlTail();
}

}  // namespace epcc
