// SPDX-License-Identifier: BSD-3-Clause
// Where points, lines and ticks of a chart are.
#include "eval/pictures/line_chart.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "eval/pictures/label_colors.h"

namespace epcc {
namespace {

bool same(const Rgb& a, const Rgb& b) {
  return a.r == b.r && a.g == b.g && a.b == b.b;
}

ChartPoint point(double x, double y, bool marked = false) {
  return {x, y, marked, ""};
}

TEST(LineChart, TicksAreRoundAndFourToTen) {
  EXPECT_DOUBLE_EQ(tickStep(1.0), 0.1);
  EXPECT_DOUBLE_EQ(tickStep(0.9), 0.1);
  EXPECT_DOUBLE_EQ(tickStep(1.7), 0.2);
  EXPECT_DOUBLE_EQ(tickStep(37.0), 5.0);
  EXPECT_DOUBLE_EQ(tickStep(80.0), 10.0);
  EXPECT_DOUBLE_EQ(tickStep(0.0), 1.0);
  for (double largest = 1e-3; largest < 1e4; largest *= 1.07) {
    EXPECT_GE(largest / tickStep(largest), 4.0) << largest;
    EXPECT_LE(largest / tickStep(largest), 10.001) << largest;
  }
}

TEST(LineChart, LinesGoFromPointToPointInTheirColours) {
  LineChart chart{"noise",
                  "correct",
                  {{"one", {point(0.0, 0.0), point(2.0, 4.0)}}, {"two", {point(0.5, 4.0, true), point(2.0, 3.0)}}}};
  const ColorImage image = drawLineChart(chart);
  EXPECT_EQ(image.width, kChartWidth);
  EXPECT_EQ(image.height, kChartHeight);
  const auto at = [&](double x, double y) {
    const ChartPixel pixel = chartPixel(chart, x, y);
    return image.at(pixel.row, pixel.column);
  };
  EXPECT_TRUE(same(at(0.5, 1.0), labelColor(1)));
  EXPECT_TRUE(same(at(0.5, 4.0), labelColor(2)));
  EXPECT_TRUE(same(at(1.25, 3.5), labelColor(2)));
  EXPECT_TRUE(same(at(1.13, 0.3), Rgb{255, 255, 255})) << "nothing there";
  EXPECT_GT(chartPixel(chart, 1.0, 0.0).column, chartPixel(chart, 0.5, 0.0).column);
  EXPECT_LT(chartPixel(chart, 0.0, 2.0).row, chartPixel(chart, 0.0, 1.0).row) << "upwards";
}

TEST(LineChart, NothingAndNotANumberAreDrawnAsNothing) {
  EXPECT_EQ(drawLineChart({}).width, kChartWidth);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const LineChart holes{"x", "y", {{"one", {point(0.0, 1.0), point(nan, 1.0), point(1.0, nan), point(1.0, 1.0)}}}};
  const LineChart without{"x", "y", {{"one", {point(0.0, 1.0), point(1.0, 1.0)}}}};
  const ColorImage a = drawLineChart(holes), b = drawLineChart(without);
  for (std::size_t i = 0; i < a.data.size(); ++i) ASSERT_TRUE(same(a.data[i], b.data[i])) << i;
}

}  // namespace
}  // namespace epcc
