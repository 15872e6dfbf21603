// SPDX-License-Identifier: BSD-3-Clause
// Turns the curve's sums into lines.
#include "eval/accuracy/accuracy_chart.h"

#include <cmath>

#include "eval/accuracy/accuracy_methods.h"
#include "eval/accuracy/accuracy_sources.h"
#include "eval/pictures/label_colors.h"

namespace epcc {

namespace {

constexpr long kMinSurfaces = 20;
constexpr double kMinDistance = 0.02;  // of the ends of a line, surfaces per surface

PlotPoint pointOf(const SummaryRow& row) {
  const auto surfaces = static_cast<double>(row.measures.paper.surfaces);
  PlotPoint point;
  point.x = static_cast<double>(row.measures.segcomp.noise) / surfaces;
  point.y = static_cast<double>(row.measures.segcomp.correct) / surfaces;
  point.large = row.method == curveDefault();
  point.text = row.method;
  return point;
}

/// Leaves the texts of the ends, unless one would cover the other.
void thinOutTexts(std::vector<PlotPoint>& points) {
  const PlotPoint &first = points.front(), &last = points.back();
  const bool apart = std::hypot(first.x - last.x, first.y - last.y) >= kMinDistance;
  for (PlotPoint& point : points)
    if (!apart || (&point != &first && &point != &last)) point.text.clear();
}

}  // namespace

Plot accuracyChart(const ExperimentSummary& curve) {
  Plot plot;
  plot.x_label = "noise clusters / surfaces";
  plot.y_label = "surfaces correct / surfaces";
  plot.width = 900;
  plot.height = 560;
  for (const std::string& dataset : accuracyDatasets()) {
    PlotSeries line{
        dataset, PlotMark::LineAndSquares, labelColor(static_cast<std::int32_t>(plot.series.size() + 1)), {}};
    for (const SummaryRow& row : curve.rows())
      if (row.dataset == dataset && row.measures.paper.surfaces >= kMinSurfaces) line.points.push_back(pointOf(row));
    if (line.points.empty()) continue;
    thinOutTexts(line.points);
    plot.series.push_back(line);
  }
  return plot;
}

}  // namespace epcc
