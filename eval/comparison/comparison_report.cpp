// SPDX-License-Identifier: BSD-3-Clause
// The same rows are written as Markdown, CSV, JSON and LaTeX.
#include "eval/comparison/comparison_report.h"

#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>

#include "datasets/files/png_io.h"
#include "datasets/support/atomic_file.h"
#include "datasets/support/output_folder.h"
#include "eval/comparison/comparison_figure.h"

namespace epcc {
namespace {

constexpr std::size_t kPublishedScores = std::tuple_size<PublishedScores>::value;
constexpr const char* kTitles[kPublishedScores] = {"IC", "D", "D/N", "N_o/N", "N_u/N"};

int decimalsOf(std::size_t score) {
  return score <= kDetected ? 1 : 2;
}

double publishedValue(const ComparisonRow& row, std::size_t score) {
  return row.published ? (*row.published)[score] : std::numeric_limits<double>::quiet_NaN();
}

/// Whole numbers of single scenes as printed, their means with a decimal.
std::string publishedCell(const ComparisonRow& row, std::size_t score) {
  const int decimals = score > kDetected ? 2 : row.scene == "mean" ? 1 : 0;
  return numberCell(publishedValue(row, score), decimals, "-");
}

std::string measuredCell(const ComparisonRow& row, std::size_t score) {
  const int decimals = decimalsOf(score);
  return numberCell(row.mean[score], decimals) + " ± " + numberCell(row.deviation[score], decimals);
}

std::string latexText(const Comparison& comparison, const ComparisonOptions& options) {
  return latexTable(comparisonTable(comparison)) + "\n\\par\\smallskip{\\small " + comparisonNote(options) + "}\n";
}

}  // namespace

Table comparisonTable(const Comparison& comparison) {
  Table table;
  table.columns = {{"scene", false}, {"method", false}, {"seeds"}, {"N"}};
  for (const char* title : kTitles) {
    table.columns.push_back({title});
    table.columns.push_back({"paper"});
  }
  table.columns.push_back({"ms"});
  for (const ComparisonRow& row : comparison.rows) {
    std::vector<std::string> cells = {row.scene, row.method, std::to_string(row.seeds),
                                      numberCell(row.surfaces, row.scene == "mean" ? 1 : 0)};
    for (std::size_t score = 0; score < kPublishedScores; ++score) {
      cells.push_back(measuredCell(row, score));
      cells.push_back(publishedCell(row, score));
    }
    cells.push_back(numberCell(row.median_ms, 0));
    table.rows.push_back(cells);
  }
  return table;
}

Table comparisonNumbers(const Comparison& comparison) {
  Table table;
  table.columns = {{"scene", false}, {"method", false}, {"seeds"}, {"N"}};
  for (std::size_t score = 0; score < kScoreCount; ++score) {
    const std::string name = kScoreNames[score];
    table.columns.push_back({name + "_mean"});
    table.columns.push_back({name + "_std"});
    if (score < kPublishedScores) table.columns.push_back({"published_" + name});
  }
  table.columns.push_back({"median_ms"});
  for (const ComparisonRow& row : comparison.rows) {
    std::vector<std::string> cells = {row.scene, row.method, std::to_string(row.seeds), numberCell(row.surfaces, 2)};
    for (std::size_t score = 0; score < kScoreCount; ++score) {
      cells.push_back(numberCell(row.mean[score], 4));
      cells.push_back(numberCell(row.deviation[score], 4));
      if (score < kPublishedScores) cells.push_back(numberCell(publishedValue(row, score), 4));
    }
    cells.push_back(numberCell(row.median_ms, 2));
    table.rows.push_back(cells);
  }
  return table;
}

std::string comparisonNote(const ComparisonOptions& options) {
  const bool paper = options.parameters == ParameterSet::Paper;
  return std::string(kSurrogateNote) + " Noise: " + options.noise_text + ". Parameters: " +
         (paper ? "Table 3 of the paper, with the noise model of Eq. 22 (d435i) for epcc-paper; the row epcc is the "
                  "project's inverse-depth mode with its defaults."
                : "the project's defaults, with the sensor model that the rendered frames name.") +
         " Mean ± standard deviation over " + std::to_string(options.seeds) + " seeds for EPCC and " +
         std::to_string(options.slow_seeds) + " for region growing and RANSAC; ms: median time of a frame.";
}

std::string comparisonJson(const Comparison& comparison, const ComparisonOptions& options) {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const ComparisonRow& row : comparison.rows) {
    nlohmann::ordered_json json = {
        {"scene", row.scene}, {"method", row.method}, {"seeds", row.seeds}, {"N", row.surfaces}};
    for (std::size_t score = 0; score < kScoreCount; ++score) {
      const std::string name = kScoreNames[score];
      json[name + "_mean"] = row.mean[score];
      json[name + "_std"] = row.deviation[score];
      if (score >= kPublishedScores) continue;
      json["published_" + name] = nullptr;
      if (row.published) json["published_" + name] = (*row.published)[score];
    }
    json["median_ms"] = row.median_ms;
    rows.push_back(json);
  }
  const nlohmann::ordered_json document = {
      {"version", 1},
      {"note", kSurrogateNote},
      {"noise", options.noise_text},
      {"parameters", options.parameters == ParameterSet::Paper ? "paper" : "default"},
      {"first_seed", options.first_seed},
      {"rows", rows}};
  return document.dump(2) + "\n";
}

std::vector<std::string> comparisonFiles() {
  return {"table4.md", "table4.csv", "table4.json", "table4.tex", "figure21.png"};
}

void writeComparison(const std::string& out, const Comparison& comparison, const ComparisonOptions& options) {
  makeOutputFolder(out);
  const std::string base = (std::filesystem::path(out) / "table4").string();
  writeTextFile(base + ".md", comparisonNote(options) + "\n\n" + markdownTable(comparisonTable(comparison)));
  writeTextFile(base + ".csv", csvTable(comparisonNumbers(comparison)));
  writeTextFile(base + ".json", comparisonJson(comparison, options));
  writeTextFile(base + ".tex", latexText(comparison, options));
  const bool paper = options.parameters == ParameterSet::Paper;
  writeRgb((std::filesystem::path(out) / "figure21.png").string(),
           comparisonFigure(comparison, paper ? "epcc-paper" : "epcc"));
}

}  // namespace epcc
