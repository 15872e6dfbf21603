// SPDX-License-Identifier: BSD-3-Clause
// Axes, ticks, lines and a legend, drawn pixel by pixel.
#include "eval/pictures/line_chart.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "eval/pictures/bitmap_font.h"
#include "eval/pictures/label_colors.h"

namespace epcc {

namespace {

constexpr int kLeft = 80, kRight = 220, kTop = 20, kBottom = 60;  // margins
constexpr int kScale = 2;                                         // of texts
constexpr int kTextHeight = kScale * kGlyphHeight;
constexpr int kTick = 6, kGap = 6;
constexpr int kDot = 3, kMark = 6, kThickness = 1;  // pixels to each side of the middle
constexpr Rgb kInk{40, 40, 40}, kPaper{255, 255, 255}, kGrid{225, 225, 225};

constexpr int plotWidth() {
  return kChartWidth - kLeft - kRight;
}
constexpr int plotHeight() {
  return kChartHeight - kTop - kBottom;
}

template <double ChartPoint::*Value>
double largest(const LineChart& chart) {
  double value = 0.0;
  for (const ChartLine& line : chart.lines)
    for (const ChartPoint& point : line.points)
      if (std::isfinite(point.*Value)) value = std::max(value, point.*Value);
  return value;
}

/// Where the axis ends: the first tick that no point is above.
double axisEnd(double largest_value) {
  const double step = tickStep(largest_value);
  return step * std::max(1.0, std::ceil(largest_value / step - 1e-9));
}

void fill(ColorImage& image, ChartPixel from, ChartPixel to, const Rgb& color) {
  for (int row = std::max(0, from.row); row <= std::min(image.height - 1, to.row); ++row)
    for (int column = std::max(0, from.column); column <= std::min(image.width - 1, to.column); ++column)
      image.at(row, column) = color;
}

void drawSquare(ColorImage& image, ChartPixel middle, int reach, const Rgb& color) {
  fill(image, {middle.column - reach, middle.row - reach}, {middle.column + reach, middle.row + reach}, color);
}

void drawStroke(ColorImage& image, ChartPixel from, ChartPixel to, const Rgb& color) {
  const int steps = std::max({1, std::abs(to.column - from.column), std::abs(to.row - from.row)});
  for (int i = 0; i <= steps; ++i)
    drawSquare(image, {from.column + (to.column - from.column) * i / steps, from.row + (to.row - from.row) * i / steps},
               kThickness, color);
}

std::string tickText(double value, double step) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*f", std::max(0, static_cast<int>(std::ceil(-std::log10(step) - 1e-9))), value);
  return text;
}

void drawAxes(ColorImage& image, const LineChart& chart) {
  const double x_end = axisEnd(largest<&ChartPoint::x>(chart)), y_end = axisEnd(largest<&ChartPoint::y>(chart));
  const double x_step = tickStep(x_end), y_step = tickStep(y_end);
  const ChartPixel origin = chartPixel(chart, 0.0, 0.0), far = chartPixel(chart, x_end, y_end);
  for (long tick = 0; tick <= std::lround(x_end / x_step); ++tick) {
    const double x = static_cast<double>(tick) * x_step;
    const int column = chartPixel(chart, x, 0.0).column;
    const std::string text = tickText(x, x_step);
    fill(image, {column, far.row}, {column, origin.row}, kGrid);
    fill(image, {column, origin.row}, {column, origin.row + kTick}, kInk);
    drawText(image, text, column - textLength(text, kScale) / 2, origin.row + kTick + kGap, kScale, kInk);
  }
  for (long tick = 0; tick <= std::lround(y_end / y_step); ++tick) {
    const double y = static_cast<double>(tick) * y_step;
    const int row = chartPixel(chart, 0.0, y).row;
    const std::string text = tickText(y, y_step);
    fill(image, {origin.column, row}, {far.column, row}, kGrid);
    fill(image, {origin.column - kTick, row}, {origin.column, row}, kInk);
    drawText(image, text, origin.column - kTick - kGap - textLength(text, kScale), row - kTextHeight / 2, kScale, kInk);
  }
  fill(image, {origin.column, far.row}, {origin.column, origin.row}, kInk);
  fill(image, {origin.column, origin.row}, {far.column, origin.row}, kInk);
  drawText(image, chart.x_title, origin.column + (plotWidth() - textLength(chart.x_title, kScale)) / 2,
           kChartHeight - kTextHeight - kGap, kScale, kInk);
  drawText(image, chart.y_title, kGap, origin.row - (plotHeight() - textLength(chart.y_title, kScale)) / 2, kScale,
           kInk, TextDirection::Up);
}

bool isDrawn(const ChartPoint& point) {
  return std::isfinite(point.x) && std::isfinite(point.y);
}

void drawLine(ColorImage& image, const LineChart& chart, const ChartLine& line, const Rgb& color) {
  const ChartPoint* last = nullptr;
  for (const ChartPoint& point : line.points) {
    if (!isDrawn(point)) continue;
    const ChartPixel pixel = chartPixel(chart, point.x, point.y);
    if (last != nullptr) drawStroke(image, chartPixel(chart, last->x, last->y), pixel, color);
    drawSquare(image, pixel, point.marked ? kMark : kDot, color);
    last = &point;
  }
}

void drawPointTexts(ColorImage& image, const LineChart& chart, const ChartLine& line) {
  for (const ChartPoint& point : line.points) {
    if (!isDrawn(point)) continue;
    const ChartPixel pixel = chartPixel(chart, point.x, point.y);
    drawText(image, point.text, pixel.column + kGap, pixel.row + kGap, kScale, kInk);
  }
}

}  // namespace

double tickStep(double largest_value) {
  if (!(largest_value > 0.0)) return 1.0;
  const double power = std::pow(10.0, std::floor(std::log10(largest_value)));
  for (const double step : {0.1, 0.2})
    if (largest_value <= 10.0 * step * power * (1.0 + 1e-9)) return step * power;
  return largest_value <= 5.0 * power * (1.0 + 1e-9) ? 0.5 * power : power;
}

ChartPixel chartPixel(const LineChart& chart, double x, double y) {
  const double x_end = axisEnd(largest<&ChartPoint::x>(chart)), y_end = axisEnd(largest<&ChartPoint::y>(chart));
  return {kLeft + static_cast<int>(std::lround(x / x_end * plotWidth())),
          kTop + plotHeight() - static_cast<int>(std::lround(y / y_end * plotHeight()))};
}

ColorImage drawLineChart(const LineChart& chart) {
  ColorImage image(kChartWidth, kChartHeight, kPaper);
  drawAxes(image, chart);
  int row = kTop + kTextHeight;
  for (std::size_t i = 0; i < chart.lines.size(); ++i, row += 2 * kTextHeight) {
    const Rgb color = labelColor(static_cast<std::int32_t>(i + 1));
    drawLine(image, chart, chart.lines[i], color);
    drawSquare(image, {kChartWidth - kRight + 20, row + kTextHeight / 2}, kMark, color);
    drawText(image, chart.lines[i].name, kChartWidth - kRight + 20 + 2 * kMark + kGap, row, kScale, kInk);
  }
  for (const ChartLine& line : chart.lines) drawPointTexts(image, chart, line);
  return image;
}

}  // namespace epcc
