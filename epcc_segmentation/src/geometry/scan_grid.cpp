// SPDX-License-Identifier: BSD-3-Clause
// Columns of even steps: what a ring is ahead of the columns' azimuth is a number of steps.
#include "geometry/scan_grid.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace epcc {

namespace {

/// Values that are not there lie between their neighbours.
void fillGaps(std::vector<double>& values) {
  std::size_t before = values.size();
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (std::isnan(values[i])) continue;
    for (std::size_t k = before == values.size() ? 0 : before + 1; k < i; ++k)
      values[k] = before == values.size()
                      ? values[i]
                      : values[before] + (values[i] - values[before]) * static_cast<double>(k - before) /
                                             static_cast<double>(i - before);
    before = i;
  }
  if (before == values.size()) return;
  for (std::size_t k = before + 1; k < values.size(); ++k) values[k] = values[before];
}

/// Mean change of azimuth from one column of the cloud to the next, 0 if it is not known.
double columnStep(const std::vector<int>& columns, const std::vector<double>& azimuth) {
  std::size_t first = azimuth.size(), last = azimuth.size();
  for (std::size_t i = 0; i < azimuth.size(); ++i) {
    if (std::isnan(azimuth[i])) continue;
    if (first == azimuth.size()) first = i;
    last = i;
  }
  return first < last ? (azimuth[last] - azimuth[first]) / (columns[last] - columns[first]) : 0.0;
}

bool isInOrder(const std::vector<double>& values) {
  std::size_t up = 0, down = 0;
  for (std::size_t i = 1; i < values.size(); ++i) (values[i] >= values[i - 1] ? up : down) += 1;
  return std::min(up, down) * 8 <= values.size();
}

}  // namespace

ScanGrid scanGrid(const PointLattice& lattice, const CloudView& cloud, const PoseHypothesis& pose,
                  const RayTables& tables) {
  ScanGrid grid;
  grid.rings_are_columns = pose.rings_are_columns;
  const int rings = pose.rings_are_columns ? cloud.width : cloud.height;
  const int columns = pose.rings_are_columns ? cloud.height : cloud.width;
  const std::vector<int>& ring_places = pose.rings_are_columns ? lattice.columns() : lattice.rows();
  const std::vector<int>& column_places = pose.rings_are_columns ? lattice.rows() : lattice.columns();
  const double step = columnStep(column_places, tables.columnAzimuth());
  if (step == 0.0) return grid;
  // A turn takes as many columns as the cloud has, to less than a column and a half.
  grid.closes_round = std::abs(std::abs(step) * columns - 2.0 * M_PI) < 1.5 * std::abs(step);

  if (ring_places.size() != static_cast<std::size_t>(rings)) return grid;  // too many rings for these tables
  std::vector<double> ahead = tables.ringAzimuth();
  fillGaps(ahead);
  std::vector<int> shift;
  for (const double azimuth : ahead) shift.push_back(static_cast<int>(std::lround(-azimuth / step)));
  const auto [least, most] = std::minmax_element(shift.begin(), shift.end());
  if (*most > *least) {
    grid.margin = grid.closes_round ? 0 : *most - *least;
    const int first = *least;
    for (int& s : shift) s = grid.closes_round ? s : s - first - grid.margin;
    grid.ring_shift = shift;
  }
  std::vector<double> elevation = tables.ringElevation();
  fillGaps(elevation);
  if (!isInOrder(elevation)) {
    grid.ring_order.resize(static_cast<std::size_t>(rings));
    std::iota(grid.ring_order.begin(), grid.ring_order.end(), 0);
    std::stable_sort(grid.ring_order.begin(), grid.ring_order.end(), [&](int a, int b) {
      return elevation[static_cast<std::size_t>(a)] > elevation[static_cast<std::size_t>(b)];
    });
  }
  return grid;
}

}  // namespace epcc
