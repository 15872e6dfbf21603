// SPDX-License-Identifier: BSD-3-Clause
// Marks, lines, ticks and texts are where their values are, and what cannot be shown is left out.
#include "eval/pictures/plot.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace epcc {
namespace {

constexpr Rgb kRed{200, 0, 0}, kGreen{0, 200, 0}, kBlue{0, 0, 200}, kPaper{255, 255, 255};
constexpr double kNan = std::numeric_limits<double>::quiet_NaN(), kInfinity = std::numeric_limits<double>::infinity();

bool same(const Rgb& a, const Rgb& b) {
  return a.r == b.r && a.g == b.g && a.b == b.b;
}

bool samePictures(const ColorImage& a, const ColorImage& b) {
  return a.width == b.width && std::equal(a.data.begin(), a.data.end(), b.data.begin(), b.data.end(), same);
}

struct Extent {
  int count = 0, left = 1 << 20, right = -1, top = 1 << 20, bottom = -1;
};

/// Of the pixels of a colour.
Extent extentOf(const ColorImage& image, const Rgb& color) {
  Extent extent;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      if (!same(image.at(y, x), color)) continue;
      ++extent.count;
      extent.left = std::min(extent.left, x);
      extent.right = std::max(extent.right, x);
      extent.top = std::min(extent.top, y);
      extent.bottom = std::max(extent.bottom, y);
    }
  return extent;
}

TEST(PlotAxis, TicksAreRoundAndFourToTen) {
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

TEST(PlotAxis, ALinearOneGoesFromTickToTickAndContainsZero) {
  EXPECT_EQ(PlotAxis(false, {1.3, 1.7}).ticks().front(), 0.0);
  EXPECT_DOUBLE_EQ(PlotAxis(false, {1.3, 1.7}).ticks().back(), 1.8);
  EXPECT_DOUBLE_EQ(PlotAxis(false, {0.4, -0.25}).ticks().front(), -0.3);
  EXPECT_DOUBLE_EQ(PlotAxis(false, {0.4, -0.25}).ticks().back(), 0.4);
  EXPECT_EQ(PlotAxis(false, {-3.0}).ticks().back(), 0.0);
  EXPECT_EQ(PlotAxis(false, {}).ticks(), (std::vector<double>{0.0, 1.0}));
  EXPECT_EQ(PlotAxis(false, {0.0}).ticks(), (std::vector<double>{0.0, 1.0}));
  const PlotAxis axis(false, {0.32});
  EXPECT_EQ(axis.tickText(0.0), "0.00") << "decimals as for the step";
  EXPECT_EQ(axis.tickText(axis.ticks()[2]), "0.10");
}

TEST(PlotAxis, ALogarithmicOneHasTicksAt125) {
  EXPECT_EQ(PlotAxis(true, {0.7, 13.0}).ticks(), (std::vector<double>{0.5, 1.0, 2.0, 5.0, 10.0, 20.0}));
  EXPECT_EQ(PlotAxis(true, {1.2, 1.8, -5.0, 0.0}).ticks(), (std::vector<double>{1.0, 2.0}));
  EXPECT_EQ(PlotAxis(true, {0.01, 0.05}).ticks(), (std::vector<double>{0.01, 0.02, 0.05}));
  EXPECT_EQ(PlotAxis(true, {5.0}).ticks(), (std::vector<double>{5.0, 10.0}));
  EXPECT_EQ(PlotAxis(true, {0.02, 2000.0}).ticks(), (std::vector<double>{0.01, 0.1, 1.0, 10.0, 100.0, 1000.0, 10000.0}))
      << "many: powers of ten alone";
  EXPECT_EQ(PlotAxis(true, {}).ticks(), (std::vector<double>{1.0, 2.0}));
  EXPECT_EQ(PlotAxis(true, {0.01}).tickText(0.02), "0.02");
}

TEST(Plot, LargerValuesAreFurtherRightAndFurtherUp) {
  Plot plot;
  plot.width = 400;
  plot.height = 300;
  plot.series = {{"", PlotMark::Dots, kRed, {{1.0, 1.0}}},
                 {"", PlotMark::Dots, kGreen, {{2.0, 3.0}}},
                 {"", PlotMark::Line, kBlue, {{1.0, 1.0}, {2.0, 3.0}}}};
  const ColorImage image = drawPlot(plot);
  ASSERT_EQ(image.width, 400);
  ASSERT_EQ(image.height, 300);
  const Extent line = extentOf(image, kBlue);
  EXPECT_GT(line.count, 300);
  EXPECT_GT(line.right, 350);
  EXPECT_LT(line.top, 60);
  const PlotAxes axes = plotAxes(plot);
  EXPECT_EQ(line.left, axes.x.at(1.0) - 1);
  EXPECT_EQ(line.bottom, axes.y.at(1.0) + 1);
  EXPECT_LT(axes.x.at(1.0), axes.x.at(2.0));
  EXPECT_GT(axes.y.at(1.0), axes.y.at(3.0));
}

TEST(Plot, LinesGoFromPointToPointInTheirColours) {
  Plot plot;
  plot.series = {{"one", PlotMark::LineAndSquares, kRed, {{0.0, 0.0}, {2.0, 4.0}}},
                 {"two", PlotMark::LineAndSquares, kBlue, {{0.5, 4.0}, {2.0, 3.0}}}};
  const ColorImage image = drawPlot(plot);
  const PlotAxes axes = plotAxes(plot);
  const auto at = [&](double x, double y) { return image.at(axes.y.at(y), axes.x.at(x)); };
  EXPECT_TRUE(same(at(0.5, 1.0), kRed));
  EXPECT_TRUE(same(at(0.5, 4.0), kBlue));
  EXPECT_TRUE(same(at(1.25, 3.5), kBlue));
  EXPECT_TRUE(same(at(1.13, 0.3), kPaper)) << "nothing there";
}

TEST(Plot, MarksHaveTheirSizes) {
  const auto widthOf = [](PlotMark mark, bool large) {
    Plot plot;
    plot.series = {{"", PlotMark::Dots, kBlue, {{2.0, 2.0}}}, {"", mark, kRed, {{1.0, 1.0, large, ""}}}};
    const Extent extent = extentOf(drawPlot(plot), kRed);
    return extent.right - extent.left + 1;
  };
  EXPECT_EQ(widthOf(PlotMark::Dots, false), 3);
  EXPECT_EQ(widthOf(PlotMark::Squares, false), 7);
  EXPECT_EQ(widthOf(PlotMark::LineAndSquares, false), 7);
  for (const PlotMark mark : {PlotMark::Dots, PlotMark::Squares, PlotMark::LineAndSquares})
    EXPECT_EQ(widthOf(mark, true), 13);
}

TEST(Plot, OnALogarithmicAxisEqualFactorsAreEqualSteps) {
  const auto squareAt = [](double value) {
    Plot plot;
    plot.log_y = true;
    plot.series = {{"", PlotMark::Line, kBlue, {{0.0, 0.01}, {0.0, 100.0}}},
                   {"", PlotMark::Squares, kRed, {{5.0, value}}}};
    return extentOf(drawPlot(plot), kRed).bottom;
  };
  EXPECT_NEAR(squareAt(0.1) - squareAt(1.0), squareAt(0.01) - squareAt(0.1), 1);
  EXPECT_GT(squareAt(0.1) - squareAt(1.0), 50);
}

TEST(Plot, WhatCannotBeShownIsLeftOut) {
  Plot plot;
  plot.log_x = plot.log_y = true;
  EXPECT_EQ(drawPlot(plot).width, 640);
  plot.series = {{"A", PlotMark::Line, kRed, {{0.0, 1.0}, {-1.0, 1.0}, {kNan, 1.0}, {kInfinity, 1.0}, {1.0, 0.0}}},
                 {"B", PlotMark::Squares, kBlue, {{3.0, 2.0}}}};
  const ColorImage image = drawPlot(plot);
  EXPECT_EQ(extentOf(image, kRed).count, 29 * 3 + 2 * 3);  // the legend's line, square at its ends, alone
}

TEST(Plot, LinesPassOverPointsThatCannotBeShown) {
  Plot holes, without;
  holes.series = {{"one", PlotMark::LineAndSquares, kRed, {{0.0, 1.0}, {kNan, 1.0}, {1.0, kNan}, {1.0, 1.0}}}};
  without.series = {{"one", PlotMark::LineAndSquares, kRed, {{0.0, 1.0}, {1.0, 1.0}}}};
  EXPECT_TRUE(samePictures(drawPlot(holes), drawPlot(without)));
}

TEST(Plot, TheLegendStandsBesideTheAxes) {
  Plot plot;
  plot.series = {{"a long name", PlotMark::Squares, kRed, {{3.0, 2.0}}}, {"", PlotMark::Line, kBlue, {{1.0, 1.0}}}};
  const int axis_end = plotAxes(plot).x.last();
  EXPECT_GT(extentOf(drawPlot(plot), kRed).right, axis_end + 10);
  EXPECT_LT(extentOf(drawPlot(plot), kBlue).right, axis_end) << "no name, no place in it";
  plot.series[0].name.clear();
  EXPECT_GT(plotAxes(plot).x.last(), axis_end) << "no legend, more room";
}

/// Pixels that differ once the points have texts.
Extent extentOfTexts(Plot plot) {
  const ColorImage with = drawPlot(plot);
  for (PlotSeries& series : plot.series)
    for (PlotPoint& point : series.points) point.text.clear();
  ColorImage difference = drawPlot(plot);
  for (std::size_t i = 0; i < with.data.size(); ++i)
    difference.data[i] = same(difference.data[i], with.data[i]) ? kPaper : kRed;
  return extentOf(difference, kRed);
}

TEST(Plot, TextsStandBesideTheirPointsAndWithinTheAxes) {
  Plot plot;
  plot.series = {{"", PlotMark::LineAndSquares, kGreen, {{0.5, 0.5, false, "12"}, {1.0, 1.0}}}};
  const PlotAxes axes = plotAxes(plot);
  Extent text = extentOfTexts(plot);
  EXPECT_NEAR(text.left, axes.x.at(0.5) + 7, 3);
  EXPECT_NEAR(text.top, axes.y.at(0.5) + 7, 3) << "below, on the right";
  plot.series[0].points = {{0.0, 0.0, true, "12"}, {0.0, 1.0}, {1.0, 0.0, true, "12"}, {1.0, 1.0}};
  text = extentOfTexts(plot);
  EXPECT_GT(text.left, axes.x.first());
  EXPECT_LT(text.right, axes.x.last());
  EXPECT_LT(text.bottom, axes.y.first());
}

TEST(Plot, TextsCoverNeitherEachOtherNorMarks) {
  const auto inkOf = [](std::vector<PlotPoint> points) {
    Plot plot;
    plot.series = {{"", PlotMark::Squares, kGreen, points}, {"", PlotMark::Dots, kBlue, {{0.0, 0.0}, {1.0, 1.0}}}};
    return extentOfTexts(plot).count;
  };
  const int one = inkOf({{0.5, 0.5, false, "8"}});
  EXPECT_GT(one, 0);
  EXPECT_EQ(inkOf({{0.5, 0.5, false, "8"}, {0.51, 0.5, false, "8"}}), 2 * one);
  EXPECT_EQ(inkOf({{0.5, 0.5, false, "8"}, {0.52, 0.48}, {0.52, 0.52}}), one) << "goes elsewhere";
  EXPECT_EQ(inkOf({{0.5, 0.5, false, "8"}, {0.5, 0.5, true, ""}}), one) << "beside the large square over it";
  std::vector<PlotPoint> crowd;
  for (int i = 0; i < 81; ++i) crowd.push_back({0.46 + 0.01 * (i % 9), 0.46 + 0.01 * (i / 9), true, ""});
  crowd[40].text = "8";
  EXPECT_EQ(inkOf(crowd), 0) << "no place is free";
}

}  // namespace
}  // namespace epcc
