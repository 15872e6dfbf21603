// SPDX-License-Identifier: BSD-3-Clause
// Shares and means of normalised squared errors, written and drawn.
#include "eval/consistency/consistency_report.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "eval/pictures/label_colors.h"

namespace epcc {

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kLeast = 0.1, kMost = 100.0;  // of the chart
constexpr int kSteps = 120;

double valueOf(int step) {
  return kLeast * std::pow(kMost / kLeast, static_cast<double>(step) / kSteps);
}

/// 95 % of a chi-square distribution lie below.
double limitOf(int degrees) {
  return degrees == 2 ? 5.991 : 7.815;
}

double shareBelow(const ConsistencyRow& row, double value) {
  const auto end = std::upper_bound(row.squares.begin(), row.squares.end(), value);
  return static_cast<double>(end - row.squares.begin()) / static_cast<double>(row.squares.size());
}

template <typename Below>
PlotSeries curve(const std::string& name, Rgb color, const Below& below) {
  PlotSeries series{name, PlotMark::Line, color, {}};
  for (int step = 0; step <= kSteps; ++step) series.points.push_back({valueOf(step), below(valueOf(step))});
  return series;
}

std::string kindOf(const ConsistencyRow& row) {
  return row.parameters == 3 ? "planes" : "lines";
}

}  // namespace

double chiSquareBelow(double value, int degrees) {
  if (!(value > 0.0)) return 0.0;
  if (degrees == 2) return 1.0 - std::exp(-0.5 * value);
  return std::erf(std::sqrt(0.5 * value)) - std::sqrt(2.0 * value / kPi) * std::exp(-0.5 * value);
}

Table consistencyTable(const std::vector<ConsistencyRow>& rows) {
  Table table;
  table.columns = {{"error", false}, {"what", false}, {"labels", false},          {"count"},
                   {"mean"},         {"median"},      {"below the 95 % limit, %"}};
  for (const ConsistencyRow& row : rows) {
    if (row.squares.empty()) continue;
    table.rows.push_back({row.error, kindOf(row), row.labels, std::to_string(row.squares.size()),
                          numberCell(row.mean(), 2), numberCell(row.quantile(0.5), 2),
                          numberCell(100.0 * shareBelow(row, limitOf(row.parameters)), 1)});
  }
  return table;
}

Table surfacesTable(const std::vector<ConsistencyRow>& rows) {
  Table table;
  table.columns = {{"error", false}, {"labels", false}, {"surface", false}, {"count"}, {"mean"}};
  for (const ConsistencyRow& row : rows) {
    std::map<std::string, std::pair<int, double>> sums;
    for (std::size_t i = 0; i < row.what.size(); ++i) {
      auto& [count, sum] = sums[row.what[i]];
      ++count;
      sum += row.by_what[i];
    }
    for (const auto& [surface, sum] : sums)
      table.rows.push_back(
          {row.error, row.labels, surface, std::to_string(sum.first), numberCell(sum.second / sum.first, 3)});
  }
  return table;
}

std::string consistencyJson(const std::vector<ConsistencyRow>& rows) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const ConsistencyRow& row : rows) {
    if (row.squares.empty()) continue;
    nlohmann::ordered_json quantiles;
    for (const char* share : {"0.05", "0.25", "0.5", "0.75", "0.95", "0.99"})
      quantiles[share] = row.quantile(std::stod(share));
    list.push_back({{"error", row.error},
                    {"labels", row.labels},
                    {"parameters", row.parameters},
                    {"count", row.squares.size()},
                    {"mean", row.mean()},
                    {"quantiles", quantiles}});
  }
  return nlohmann::ordered_json{{"version", 1}, {"rows", list}}.dump(2) + "\n";
}

Plot consistencyChart(const std::vector<ConsistencyRow>& rows, int parameters) {
  Plot plot;
  plot.x_label = "normalised squared error";
  plot.y_label = parameters == 3 ? "share of the planes below" : "share of the line segments below";
  plot.log_x = true;
  plot.width = 900;
  plot.height = 520;
  for (const ConsistencyRow& row : rows) {
    if (row.parameters != parameters || row.squares.empty()) continue;
    if (parameters == 3 && row.error != "white" && row.error != "stereo") continue;
    const std::string name = parameters == 3 ? row.error + ", " + row.labels : row.error;
    plot.series.push_back(curve(name, labelColor(static_cast<std::int32_t>(plot.series.size() + 1)),
                                [&](double value) { return shareBelow(row, value); }));
  }
  plot.series.push_back(curve("chi-square, " + std::to_string(parameters), Rgb{0, 0, 0},
                              [&](double value) { return chiSquareBelow(value, parameters); }));
  return plot;
}

}  // namespace epcc
