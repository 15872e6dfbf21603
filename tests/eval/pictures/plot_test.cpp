// SPDX-License-Identifier: BSD-3-Clause
// Marks are where their values are, and what cannot be shown is left out.
#include "eval/pictures/plot.h"

#include <gtest/gtest.h>

#include <cmath>

namespace epcc {
namespace {

constexpr Rgb kRed{200, 0, 0};

struct Extent {
  int count = 0, left = 1 << 20, right = -1, top = 1 << 20, bottom = -1;
};

/// Of the pixels of a colour.
Extent extentOf(const ColorImage& image, const Rgb& color) {
  Extent extent;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const Rgb& pixel = image.at(y, x);
      if (pixel.r != color.r || pixel.g != color.g || pixel.b != color.b) continue;
      ++extent.count;
      extent.left = std::min(extent.left, x);
      extent.right = std::max(extent.right, x);
      extent.top = std::min(extent.top, y);
      extent.bottom = std::max(extent.bottom, y);
    }
  return extent;
}

TEST(Plot, LargerValuesAreFurtherRightAndFurtherUp) {
  Plot plot;
  plot.series = {{"A", PlotMark::Dots, kRed, {1.0}, {1.0}},
                 {"B", PlotMark::Dots, {0, 200, 0}, {2.0}, {3.0}},
                 {"", PlotMark::Line, {0, 0, 200}, {1.0, 2.0}, {1.0, 3.0}}};
  const ColorImage image = drawPlot(plot, 400, 300);
  ASSERT_EQ(image.width, 400);
  ASSERT_EQ(image.height, 300);
  const Extent line = extentOf(image, {0, 0, 200});
  EXPECT_GT(line.count, 300);
  EXPECT_GT(line.right, 350);
  EXPECT_LT(line.top, 60);
}

TEST(Plot, OnALogarithmicAxisEqualFactorsAreEqualSteps) {
  const auto dotAt = [](double value) {
    Plot plot;
    plot.log_y = true;
    plot.series = {{"", PlotMark::Line, {0, 0, 200}, {0.0, 0.0}, {0.01, 100.0}},
                   {"", PlotMark::Squares, kRed, {5.0}, {value}}};
    const Extent legend_and_mark = extentOf(drawPlot(plot), kRed);
    return legend_and_mark.bottom;
  };
  EXPECT_NEAR(dotAt(0.1) - dotAt(1.0), dotAt(0.01) - dotAt(0.1), 1);
  EXPECT_GT(dotAt(0.1) - dotAt(1.0), 50);
}

TEST(Plot, WhatCannotBeShownIsLeftOut) {
  Plot plot;
  plot.log_x = plot.log_y = true;
  EXPECT_EQ(drawPlot(plot).width, 640);
  plot.series = {{"A", PlotMark::Line, kRed, {0.0, -1.0, NAN, INFINITY}, {1.0, 1.0, 1.0, 1.0}},
                 {"B", PlotMark::Squares, {0, 0, 200}, {3.0, 4.0}, {2.0}}};  // a value without a partner
  const ColorImage image = drawPlot(plot);
  EXPECT_EQ(extentOf(image, kRed).count, 29 * 3 + 2 * 3);  // the legend's line, square at its ends, alone
}

}  // namespace
}  // namespace epcc
