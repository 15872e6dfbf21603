// SPDX-License-Identifier: BSD-3-Clause
// Plots of a few series over two axes, without a plotting program.
#pragma once

#include <string>
#include <vector>

#include "datasets/files/image.h"
#include "eval/pictures/plot_axis.h"

namespace epcc {

/// How a series is drawn. A line goes from point to point in their order.
enum class PlotMark { Dots, Squares, Line, LineAndSquares };

struct PlotPoint {
  double x = 0.0, y = 0.0;
  bool large = false;     ///< its dot or square
  std::string text = {};  ///< beside the point, may be empty
};

struct PlotSeries {
  std::string name;  ///< in the legend, which leaves out a series without name
  PlotMark mark = PlotMark::Line;
  Rgb color;
  std::vector<PlotPoint> points;
};

struct Plot {
  std::string title, x_label, y_label;
  bool log_x = false, log_y = false;
  std::vector<PlotSeries> series;  ///< drawn in this order
  int width = 640, height = 480;   ///< of the picture, pixels
};

struct PlotAxes {
  PlotAxis x, y;
};
/// Where values are in the picture: x.at(value) is the column, y.at(value) the row.
PlotAxes plotAxes(const Plot& plot);

/// Points of which a coordinate cannot be shown (PlotAxis::canShow) are left out. The legend stands on the right of the
/// axes. Texts are drawn where they cover nothing, and left out if there is no such place beside their point.
ColorImage drawPlot(const Plot& plot);

}  // namespace epcc
