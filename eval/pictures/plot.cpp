// SPDX-License-Identifier: BSD-3-Clause
// Axes with round numbers, marks, lines and a legend, pixel by pixel.
#include "eval/pictures/plot.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "eval/pictures/bitmap_font.h"

namespace epcc {
namespace {

constexpr Rgb kInk{20, 20, 20};
constexpr Rgb kGrid{225, 225, 225};
constexpr int kTextScale = 2;
constexpr int kLeft = 84, kRight = 16, kTop = 34, kBottom = 58;  // margins, pixels

/// One direction: values to pixels.
struct Axis {
  bool log = false;
  int first = 0, last = 0;  // pixels
  double low = 0.0, high = 1.0;

  bool shows(double value) const { return std::isfinite(value) && (!log || value > 0.0); }
  double scaled(double value) const { return log ? std::log10(value) : value; }
  double at(double value) const { return first + (scaled(value) - low) / (high - low) * (last - first); }

  void fitTo(const std::vector<double>& values) {
    bool any = false;
    for (const double value : values) {
      if (!shows(value)) continue;
      const double v = scaled(value);
      low = any ? std::min(low, v) : v;
      high = any ? std::max(high, v) : v;
      any = true;
    }
    const double margin = high > low ? 0.05 * (high - low) : 0.5;
    low -= margin;
    high += margin;
  }

  /// Round numbers within: 1, 2, 5 times powers of ten.
  std::vector<double> ticks() const {
    std::vector<double> result;
    if (log) {
      for (int power = static_cast<int>(std::floor(low)); power <= high; ++power)
        for (const double digit : {1.0, 2.0, 5.0}) {
          const double value = digit * std::pow(10.0, power);
          if (scaled(value) >= low && scaled(value) <= high) result.push_back(value);
        }
      return result;
    }
    const double power = std::pow(10.0, std::floor(std::log10(high - low)));
    const double spans = (high - low) / power;
    const double step = power * (spans < 2.0 ? 0.2 : spans < 5.0 ? 0.5 : 1.0);
    for (double value = std::ceil(low / step) * step; value <= high; value += step)
      result.push_back(std::abs(value) < 0.01 * step ? 0.0 : value);
    return result;
  }
};

std::string tickText(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

void put(ColorImage& image, int x, int y, const Rgb& color) {
  if (x >= 0 && y >= 0 && x < image.width && y < image.height) image.at(y, x) = color;
}

void fillSquare(ColorImage& image, int x, int y, int half, const Rgb& color) {
  for (int dy = -half; dy <= half; ++dy)
    for (int dx = -half; dx <= half; ++dx) put(image, x + dx, y + dy, color);
}

void drawLine(ColorImage& image, double x0, double y0, double x1, double y1, int half, const Rgb& color) {
  const int steps = std::max(1, static_cast<int>(std::ceil(std::max(std::abs(x1 - x0), std::abs(y1 - y0)))));
  for (int i = 0; i <= steps; ++i) {
    const double t = static_cast<double>(i) / steps;
    fillSquare(image, static_cast<int>(std::lround(x0 + t * (x1 - x0))),
               static_cast<int>(std::lround(y0 + t * (y1 - y0))), half, color);
  }
}

void drawSeries(ColorImage& image, const PlotSeries& series, const Axis& x, const Axis& y) {
  const std::size_t count = std::min(series.x.size(), series.y.size());
  const auto shown = [&](std::size_t i) { return x.shows(series.x[i]) && y.shows(series.y[i]); };
  for (std::size_t i = 0; i < count; ++i) {
    if (!shown(i)) continue;
    const double px = x.at(series.x[i]), py = y.at(series.y[i]);
    if (series.mark != PlotMark::Line)
      fillSquare(image, static_cast<int>(std::lround(px)), static_cast<int>(std::lround(py)),
                 series.mark == PlotMark::Dots ? 1 : 4, series.color);
    else if (i > 0 && shown(i - 1))
      drawLine(image, x.at(series.x[i - 1]), y.at(series.y[i - 1]), px, py, 1, series.color);
  }
}

void drawAxes(ColorImage& image, const Plot& plot, const Axis& x, const Axis& y) {
  const int text_height = kGlyphHeight * kTextScale;
  int free_from = -1;  // so that numbers do not touch
  for (const double tick : x.ticks()) {
    const int at = static_cast<int>(std::lround(x.at(tick)));
    drawLine(image, at, y.first, at, y.last, 0, kGrid);
    const std::string text = tickText(tick);
    const int length = textLength(text, kTextScale);
    if (at - length / 2 < free_from) continue;
    drawText(image, text, at - length / 2, y.first + 8, kTextScale, kInk);
    free_from = at + length / 2 + 8;
  }
  int free_below = image.height;
  for (const double tick : y.ticks()) {
    const int at = static_cast<int>(std::lround(y.at(tick)));
    drawLine(image, x.first, at, x.last, at, 0, kGrid);
    if (at + text_height / 2 > free_below) continue;
    const std::string text = tickText(tick);
    drawText(image, text, x.first - 8 - textLength(text, kTextScale), at - text_height / 2, kTextScale, kInk);
    free_below = at - text_height / 2 - 4;
  }
  for (const int at : {y.first, y.last}) drawLine(image, x.first, at, x.last, at, 0, kInk);
  for (const int at : {x.first, x.last}) drawLine(image, at, y.first, at, y.last, 0, kInk);
  const auto centred = [](int first, int last, int length) { return (first + last - length) / 2; };
  drawText(image, plot.title, centred(x.first, x.last, textLength(plot.title, kTextScale)), 10, kTextScale, kInk);
  drawText(image, plot.x_label, centred(x.first, x.last, textLength(plot.x_label, kTextScale)),
           image.height - text_height - 8, kTextScale, kInk);
  drawText(image, plot.y_label, 6, centred(y.first, y.last, -textLength(plot.y_label, kTextScale)), kTextScale, kInk,
           TextDirection::Up);
}

/// In the upper left corner of the axes, or where `right` says in the upper right one.
void drawLegend(ColorImage& image, const Plot& plot, const Axis& x, const Axis& y, bool right) {
  int longest = 0;
  for (const PlotSeries& series : plot.series) longest = std::max(longest, textLength(series.name, kTextScale));
  const int left = right ? x.last - longest - 52 : x.first + 12;
  int top = y.last + 10;
  for (const PlotSeries& series : plot.series) {
    const int middle = top + kGlyphHeight * kTextScale / 2;
    if (series.mark == PlotMark::Line)
      drawLine(image, left, middle, left + 28, middle, 1, series.color);
    else
      fillSquare(image, left + 14, middle, series.mark == PlotMark::Dots ? 1 : 4, series.color);
    drawText(image, series.name, left + 38, top, kTextScale, kInk);
    top += kGlyphHeight * kTextScale + 8;
  }
}

}  // namespace

ColorImage drawPlot(const Plot& plot, int width, int height) {
  ColorImage image(width, height, Rgb{255, 255, 255});
  Axis x{plot.log_x, kLeft, width - kRight}, y{plot.log_y, height - kBottom, kTop};
  std::vector<double> all_x, all_y;
  for (const PlotSeries& series : plot.series)
    for (std::size_t i = 0; i < std::min(series.x.size(), series.y.size()); ++i) {
      const Axis log_x{plot.log_x}, log_y{plot.log_y};
      if (!log_x.shows(series.x[i]) || !log_y.shows(series.y[i])) continue;
      all_x.push_back(series.x[i]);
      all_y.push_back(series.y[i]);
    }
  x.fitTo(all_x);
  y.fitTo(all_y);
  drawAxes(image, plot, x, y);
  for (const PlotSeries& series : plot.series) drawSeries(image, series, x, y);
  // Where there is less: a curve that rises leaves the upper left free, one that falls the upper right.
  const bool rises = !plot.series.empty() && !plot.series.back().y.empty() &&
                     plot.series.back().y.back() > plot.series.back().y.front();
  drawLegend(image, plot, x, y, !rises);
  return image;
}

}  // namespace epcc
