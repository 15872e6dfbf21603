// SPDX-License-Identifier: BSD-3-Clause
// Curves in a frame with two axes, without a plotting program.
#pragma once

#include <string>
#include <vector>

#include "datasets/files/image.h"

namespace epcc {

struct ChartPoint {
  double x = 0.0, y = 0.0;
  bool marked = false;  ///< drawn larger
  std::string text;     ///< beside the point, may be empty
};

struct ChartLine {
  std::string name;
  std::vector<ChartPoint> points;
};

/// Both axes start at 0 and end at a tick that no point is above.
struct LineChart {
  std::string x_title, y_title;
  std::vector<ChartLine> lines;  ///< line k in the colour labelColor(k + 1)
};

constexpr int kChartWidth = 900;
constexpr int kChartHeight = 560;

/// Distance of ticks on an axis from 0 to `largest`: 1, 2 or 5 times a power of ten, four to ten of them.
double tickStep(double largest);
/// Pixel of a point: column, row.
struct ChartPixel {
  int column = 0, row = 0;
};
ChartPixel chartPixel(const LineChart& chart, double x, double y);

/// Points that are not finite are left out. The legend stands on the right.
ColorImage drawLineChart(const LineChart& chart);

}  // namespace epcc
