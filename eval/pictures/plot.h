// SPDX-License-Identifier: BSD-3-Clause
// Plots of a few series over two axes.
#pragma once

#include <string>
#include <vector>

#include "datasets/files/image.h"

namespace epcc {

enum class PlotMark { Dots, Squares, Line };

struct PlotSeries {
  std::string name;  ///< in the legend
  PlotMark mark = PlotMark::Line;
  Rgb color;
  std::vector<double> x, y;
};

struct Plot {
  std::string title, x_label, y_label;
  bool log_x = false;  ///< values that are not positive are left out
  bool log_y = false;
  std::vector<PlotSeries> series;  ///< drawn in this order
};

/// The axes cover what is finite; without anything to show they are empty.
ColorImage drawPlot(const Plot& plot, int width = 640, int height = 480);

}  // namespace epcc
