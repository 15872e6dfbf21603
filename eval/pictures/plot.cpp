// SPDX-License-Identifier: BSD-3-Clause
// Axes, marks, lines, texts and a legend, pixel by pixel.
#include "eval/pictures/plot.h"

#include <algorithm>
#include <cmath>

#include "eval/pictures/bitmap_font.h"

namespace epcc {
namespace {

constexpr Rgb kInk{30, 30, 30}, kPaper{255, 255, 255}, kGrid{225, 225, 225};
constexpr int kTextScale = 2;
constexpr int kTextHeight = kTextScale * kGlyphHeight;
constexpr int kTick = 6, kGap = 6, kWideGap = 12;                // pixels
constexpr int kDot = 1, kSquare = 3, kLarge = 6, kHalfLine = 1;  // pixels to each side of the middle
constexpr int kLegendMark = 28;                                  // length of a line there

struct Pixel {
  int x = 0, y = 0;
};

bool isShown(const Plot& plot, const PlotPoint& point) {
  return PlotAxis::canShow(plot.log_x, point.x) && PlotAxis::canShow(plot.log_y, point.y);
}

Pixel pixelOf(const PlotAxes& axes, const PlotPoint& point) {
  return {axes.x.at(point.x), axes.y.at(point.y)};
}

void fill(ColorImage& image, Pixel from, Pixel to, const Rgb& color) {
  for (int y = std::max(0, from.y); y <= std::min(image.height - 1, to.y); ++y)
    for (int x = std::max(0, from.x); x <= std::min(image.width - 1, to.x); ++x) image.at(y, x) = color;
}

void drawSquare(ColorImage& image, Pixel middle, int reach, const Rgb& color) {
  fill(image, {middle.x - reach, middle.y - reach}, {middle.x + reach, middle.y + reach}, color);
}

void drawLine(ColorImage& image, Pixel from, Pixel to, const Rgb& color) {
  const int steps = std::max({1, std::abs(to.x - from.x), std::abs(to.y - from.y)});
  for (int i = 0; i <= steps; ++i) {
    const double t = static_cast<double>(i) / steps;
    drawSquare(image,
               {from.x + static_cast<int>(std::lround(t * (to.x - from.x))),
                from.y + static_cast<int>(std::lround(t * (to.y - from.y)))},
               kHalfLine, color);
  }
}

bool hasLine(const PlotSeries& series) {
  return series.mark == PlotMark::Line || series.mark == PlotMark::LineAndSquares;
}

/// Of a point's mark, to each side.
int reachOf(const PlotSeries& series, bool large) {
  if (series.mark == PlotMark::Line) return kHalfLine;
  if (large) return kLarge;
  return series.mark == PlotMark::Dots ? kDot : kSquare;
}

void drawXTicks(ColorImage& image, const PlotAxes& axes) {
  int free_from = 0;  // so that numbers do not touch
  for (const double tick : axes.x.ticks()) {
    const int at = axes.x.at(tick);
    fill(image, {at, axes.y.last()}, {at, axes.y.first()}, kGrid);
    fill(image, {at, axes.y.first()}, {at, axes.y.first() + kTick}, kInk);
    const std::string text = axes.x.tickText(tick);
    const int length = textLength(text, kTextScale);
    if (at - length / 2 < free_from) continue;
    drawText(image, text, at - length / 2, axes.y.first() + kTick + kGap, kTextScale, kInk);
    free_from = at + length / 2 + kWideGap;
  }
}

void drawYTicks(ColorImage& image, const PlotAxes& axes) {
  int free_below = image.height;
  for (const double tick : axes.y.ticks()) {
    const int at = axes.y.at(tick);
    fill(image, {axes.x.first(), at}, {axes.x.last(), at}, kGrid);
    fill(image, {axes.x.first() - kTick, at}, {axes.x.first(), at}, kInk);
    if (at + kTextHeight / 2 > free_below) continue;
    const std::string text = axes.y.tickText(tick);
    drawText(image, text, axes.x.first() - kTick - kGap - textLength(text, kTextScale), at - kTextHeight / 2,
             kTextScale, kInk);
    free_below = at - kTextHeight / 2 - kGap;
  }
}

void drawAxes(ColorImage& image, const Plot& plot, const PlotAxes& axes) {
  const PlotAxis &x = axes.x, &y = axes.y;
  drawXTicks(image, axes);
  drawYTicks(image, axes);
  for (const int at : {y.first(), y.last()}) fill(image, {x.first(), at}, {x.last(), at}, kInk);
  for (const int at : {x.first(), x.last()}) fill(image, {at, y.last()}, {at, y.first()}, kInk);
  const auto indent = [](const PlotAxis& axis, const std::string& text) {
    return (std::abs(axis.last() - axis.first()) - textLength(text, kTextScale)) / 2;
  };
  drawText(image, plot.title, x.first() + indent(x, plot.title), kWideGap, kTextScale, kInk);
  drawText(image, plot.x_label, x.first() + indent(x, plot.x_label), image.height - kTextHeight - kGap, kTextScale,
           kInk);
  drawText(image, plot.y_label, kGap, y.first() - indent(y, plot.y_label), kTextScale, kInk, TextDirection::Up);
}

void drawSeries(ColorImage& image, const Plot& plot, const PlotSeries& series, const PlotAxes& axes) {
  const PlotPoint* previous = nullptr;
  for (const PlotPoint& point : series.points) {
    if (!isShown(plot, point)) continue;
    const Pixel pixel = pixelOf(axes, point);
    if (hasLine(series) && previous != nullptr) drawLine(image, pixelOf(axes, *previous), pixel, series.color);
    drawSquare(image, pixel, reachOf(series, point.large), series.color);
    previous = &point;
  }
}

/// Whether nothing but the grid is in a rectangle within the axes.
bool isFree(const ColorImage& image, const PlotAxes& axes, Pixel from, Pixel to) {
  if (from.x <= axes.x.first() || to.x >= axes.x.last() || from.y <= axes.y.last() || to.y >= axes.y.first())
    return false;
  const auto same = [](const Rgb& a, const Rgb& b) { return a.r == b.r && a.g == b.g && a.b == b.b; };
  for (int y = from.y; y <= to.y; ++y)
    for (int x = from.x; x <= to.x; ++x)
      if (!same(image.at(y, x), kPaper) && !same(image.at(y, x), kGrid)) return false;
  return true;
}

/// Places of a text beside its point, the best first: right of it before left of it, below it before above it.
std::vector<Pixel> placesBeside(Pixel point, int distance, int length) {
  const int right = point.x + distance, left = point.x - distance - length + 1, middle_x = point.x - length / 2;
  const int below = point.y + distance, above = point.y - distance - kTextHeight + 1;
  const int middle_y = point.y - kTextHeight / 2;
  return {{right, below}, {right, above},   {right, middle_y}, {left, below},
          {left, above},  {left, middle_y}, {middle_x, below}, {middle_x, above}};
}

void drawPointText(ColorImage& image, const PlotAxes& axes, Pixel point, int reach, const std::string& text) {
  constexpr int kApart = 4, kClear = 2;  // from the mark, and from everything else
  const int length = textLength(text, kTextScale);
  // The second distance is for a small mark that a large one covers.
  for (const int distance : {reach + kApart, kLarge + kApart})
    for (const Pixel& at : placesBeside(point, distance, length)) {
      const Pixel end{at.x + length - 1, at.y + kTextHeight - 1};
      if (!isFree(image, axes, {at.x - kClear, at.y - kClear}, {end.x + kClear, end.y + kClear})) continue;
      drawText(image, text, at.x, at.y, kTextScale, kInk);
      return;
    }
}

int legendWidth(const Plot& plot) {
  int longest = 0;
  for (const PlotSeries& series : plot.series) longest = std::max(longest, textLength(series.name, kTextScale));
  return longest > 0 ? kWideGap + kLegendMark + kWideGap + longest + kGap : 0;
}

void drawLegend(ColorImage& image, const Plot& plot, const PlotAxes& axes) {
  Pixel at{axes.x.last() + kWideGap, axes.y.last() + kTextHeight};
  for (const PlotSeries& series : plot.series) {
    if (series.name.empty()) continue;
    const int middle = at.y + kTextHeight / 2;
    if (hasLine(series)) drawLine(image, {at.x, middle}, {at.x + kLegendMark, middle}, series.color);
    drawSquare(image, {at.x + kLegendMark / 2, middle}, reachOf(series, false), series.color);
    drawText(image, series.name, at.x + kLegendMark + kWideGap, at.y, kTextScale, kInk);
    at.y += kTextHeight + kWideGap;
  }
}

}  // namespace

PlotAxes plotAxes(const Plot& plot) {
  std::vector<double> all_x, all_y;
  for (const PlotSeries& series : plot.series)
    for (const PlotPoint& point : series.points) {
      if (!isShown(plot, point)) continue;
      all_x.push_back(point.x);
      all_y.push_back(point.y);
    }
  PlotAxes axes{PlotAxis(plot.log_x, all_x), PlotAxis(plot.log_y, all_y)};
  const int half_number = axes.x.longestText(kTextScale) / 2 + kGap;  // of the last tick, beyond the axis
  const int left = kGap + kTextHeight + kWideGap + axes.y.longestText(kTextScale) + kGap + kTick;
  const int right = std::max(half_number, legendWidth(plot));
  const int top = plot.title.empty() ? kTextHeight : 2 * kWideGap + kTextHeight;
  const int bottom = kTick + kGap + kTextHeight + kWideGap + kTextHeight + kGap;
  axes.x.setPixels(left, plot.width - 1 - right);
  axes.y.setPixels(plot.height - 1 - bottom, top);
  return axes;
}

ColorImage drawPlot(const Plot& plot) {
  ColorImage image(plot.width, plot.height, kPaper);
  const PlotAxes axes = plotAxes(plot);
  drawAxes(image, plot, axes);
  for (const PlotSeries& series : plot.series) drawSeries(image, plot, series, axes);
  for (const PlotSeries& series : plot.series)
    for (const PlotPoint& point : series.points)
      if (!point.text.empty() && isShown(plot, point))
        drawPointText(image, axes, pixelOf(axes, point), reachOf(series, point.large), point.text);
  drawLegend(image, plot, axes);
  return image;
}

}  // namespace epcc
