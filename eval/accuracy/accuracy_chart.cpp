// SPDX-License-Identifier: BSD-3-Clause
// Turns the curve's sums into lines.
#include "eval/accuracy/accuracy_chart.h"

#include <cmath>

#include "eval/accuracy/accuracy_methods.h"
#include "eval/accuracy/accuracy_sources.h"

namespace epcc {

namespace {

constexpr long kMinSurfaces = 20;
constexpr double kMinDistance = 0.02;  // of the ends of a line, surfaces per surface

ChartPoint pointOf(const SummaryRow& row) {
  const auto surfaces = static_cast<double>(row.measures.paper.surfaces);
  ChartPoint point;
  point.x = static_cast<double>(row.measures.segcomp.noise) / surfaces;
  point.y = static_cast<double>(row.measures.segcomp.correct) / surfaces;
  point.marked = row.method == curveDefault();
  point.text = row.method;
  return point;
}

/// Leaves the texts of the ends, unless one would cover the other.
void thinOutTexts(std::vector<ChartPoint>& points) {
  const ChartPoint &first = points.front(), &last = points.back();
  const bool apart = std::hypot(first.x - last.x, first.y - last.y) >= kMinDistance;
  for (ChartPoint& point : points)
    if (!apart || (&point != &first && &point != &last)) point.text.clear();
}

}  // namespace

LineChart accuracyChart(const ExperimentSummary& curve) {
  LineChart chart{"noise clusters / surfaces", "surfaces correct / surfaces", {}};
  for (const std::string& dataset : accuracyDatasets()) {
    ChartLine line{dataset, {}};
    for (const SummaryRow& row : curve.rows())
      if (row.dataset == dataset && row.measures.paper.surfaces >= kMinSurfaces) line.points.push_back(pointOf(row));
    if (line.points.empty()) continue;
    thinOutTexts(line.points);
    chart.lines.push_back(line);
  }
  return chart;
}

}  // namespace epcc
