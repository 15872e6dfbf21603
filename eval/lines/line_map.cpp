// SPDX-License-Identifier: BSD-3-Clause
// One layout, two ways to draw it.
#include "eval/lines/line_map.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>
#include <utility>

#include "eval/pictures/bitmap_font.h"
#include "eval/pictures/label_colors.h"
#include "eval/pictures/plot_axis.h"

namespace epcc {
namespace {

constexpr Rgb kPaper{255, 255, 255}, kInk{30, 30, 30}, kPoint{165, 165, 165}, kPosition{60, 60, 60};
constexpr int kLongSide = 1200, kMargin = 40, kTextScale = 2;  // pixels
constexpr double kFarthestShare =
    0.02;  // of the points may lie outside on each side: a few stray beams shrink the rest

/// Metres to pixels.
struct Layout {
  double scale = 1.0, left = 0.0, top = 0.0;
  int width = kLongSide, height = kLongSide;
  double bar = 1.0;  // metres

  Vector2 at(const Vector2& point) const {
    return {kMargin + scale * (point.x() - left), kMargin + scale * (top - point.y())};
  }
};

struct Interval {
  double low = 0.0, high = 0.0;
};

/// Contains all segments and positions, and of the points all but the farthest.
Interval intervalOf(const LineMap& map, int axis) {
  std::vector<double> points, values;
  for (const Vector2& point : map.points) points.push_back(point(axis));
  std::sort(points.begin(), points.end());
  if (!points.empty()) {
    const auto cut = static_cast<std::size_t>(kFarthestShare * static_cast<double>(points.size()));
    values = {points[cut], points[points.size() - 1 - cut]};
  }
  for (const LineMap::Segment& segment : map.segments)
    for (const Vector2& end : {segment.start, segment.end}) values.push_back(end(axis));
  for (const Vector2& position : map.positions) values.push_back(position(axis));
  if (values.empty()) return {};
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return {*low, *high};
}

Layout layOut(const LineMap& map) {
  const Interval x = intervalOf(map, 0), y = intervalOf(map, 1);
  const double longest = std::max({x.high - x.low, y.high - y.low, 0.1});
  Layout layout;
  layout.scale = (kLongSide - 2 * kMargin) / longest;
  layout.left = x.low;
  layout.top = y.high;
  const auto side = [&](const Interval& interval) {
    return std::max(kLongSide / 4,
                    2 * kMargin + static_cast<int>(std::ceil(layout.scale * (interval.high - interval.low))));
  };
  layout.width = side(x);
  layout.height = side(y);
  layout.bar = tickStep(longest);
  return layout;
}

/// Where dots go, each pixel once.
std::set<std::pair<int, int>> pixelsOf(const std::vector<Vector2>& points, const Layout& layout) {
  std::set<std::pair<int, int>> pixels;
  for (const Vector2& point : points) {
    const Vector2 at = layout.at(point);
    if (!(at.x() >= 0.0 && at.y() >= 0.0 && at.x() < layout.width && at.y() < layout.height)) continue;
    pixels.emplace(static_cast<int>(at.x()), static_cast<int>(at.y()));
  }
  return pixels;
}

void blend(ColorImage& image, int x, int y, const Rgb& color, double share) {
  if (x < 0 || y < 0 || x >= image.width || y >= image.height || share <= 0.0) return;
  Rgb& pixel = image.at(y, x);
  const auto mixed = [&](std::uint8_t old, std::uint8_t wanted) {
    return static_cast<std::uint8_t>(std::lround(old + std::min(1.0, share) * (wanted - old)));
  };
  pixel = {mixed(pixel.r, color.r), mixed(pixel.g, color.g), mixed(pixel.b, color.b)};
}

/// A line with round ends and soft borders.
void drawStroke(ColorImage& image, const Vector2& from, const Vector2& to, double width, const Rgb& color) {
  const double reach = 0.5 * width + 1.0;
  const Vector2 step = to - from;
  const double square = std::max(1e-12, step.squaredNorm());
  const auto bound = [](double value, int size) { return static_cast<int>(std::clamp(value, -1.0, size + 1.0)); };
  const int left = bound(std::min(from.x(), to.x()) - reach, image.width);
  const int right = bound(std::max(from.x(), to.x()) + reach, image.width);
  const int top = bound(std::min(from.y(), to.y()) - reach, image.height);
  const int bottom = bound(std::max(from.y(), to.y()) + reach, image.height);
  for (int y = top; y <= bottom; ++y)
    for (int x = left; x <= right; ++x) {
      const Vector2 pixel(x + 0.5, y + 0.5);
      const double along = std::clamp((pixel - from).dot(step) / square, 0.0, 1.0);
      const double distance = (pixel - from - along * step).norm();
      blend(image, x, y, color, 0.5 * width + 0.5 - distance);
    }
}

std::string colorText(const Rgb& color) {
  char text[8];
  std::snprintf(text, sizeof text, "#%02x%02x%02x", color.r, color.g, color.b);
  return text;
}

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f", value);
  return text;
}

std::string barText(double metres) {
  char text[32];
  std::snprintf(text, sizeof text, "%g M", metres);
  return text;
}

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) result += c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : std::string(1, c);
  return result;
}

/// A colour of the wheel, turn from 0 to 1.
Rgb wheelColor(double turn) {
  const auto channel = [&](double shift) {
    const double wave = 0.5 + 0.5 * std::cos(6.283185307179586 * (turn - shift));
    return static_cast<std::uint8_t>(std::lround(30.0 + 190.0 * wave));
  };
  return {channel(0.0), channel(1.0 / 3.0), channel(2.0 / 3.0)};
}

std::vector<Vector2> pointsOf(const LaserScan& scan) {
  std::vector<Vector2> points;
  for (std::size_t i = 0; i < scan.ranges.size(); ++i)
    if (scan.hasReturn(i)) points.push_back(scan.ranges[i] * Vector2(std::cos(scan.angle(i)), std::sin(scan.angle(i))));
  return points;
}

}  // namespace

LineMap scanMap(const LaserRecord& record, const LaserLines& lines, const std::string& title) {
  LineMap map;
  map.title = title;
  map.points = pointsOf(record.scan);
  map.positions = {Vector2::Zero()};
  for (std::size_t k = 0; k < lines.lines.size(); ++k)
    map.segments.push_back({lines.lines[k].start, lines.lines[k].end, labelColor(static_cast<std::int32_t>(k + 1))});
  return map;
}

LineMap logMap(const LaserLog& log, const LogLines& lines, const std::string& title) {
  LineMap map;
  map.title = title;
  map.segment_width = 1.5;
  for (std::size_t i = 0; i < log.records.size(); ++i) {
    if (!log.records[i].pose) continue;
    const LaserPose& pose = *log.records[i].pose;
    map.positions.push_back({pose.x, pose.y});
    for (const Vector2& point : pointsOf(log.records[i].scan)) map.points.push_back(pose.toWorld(point));
    for (const LaserLine& line : lines.scans[i].lines) {
      const double turn = (line.alpha + pose.theta) / std::acos(-1.0);
      map.segments.push_back({pose.toWorld(line.start), pose.toWorld(line.end), wheelColor(turn - std::floor(turn))});
    }
  }
  return map;
}

ColorImage drawMap(const LineMap& map) {
  const Layout layout = layOut(map);
  ColorImage image(layout.width, layout.height, kPaper);
  const double dot = map.points.size() > 5000 ? 0.5 : 1.5;
  for (const auto& [x, y] : pixelsOf(map.points, layout)) {
    const Vector2 at(x + 0.5, y + 0.5);
    drawStroke(image, at, at, 2.0 * dot, kPoint);
  }
  for (const LineMap::Segment& segment : map.segments)
    drawStroke(image, layout.at(segment.start), layout.at(segment.end), map.segment_width, segment.color);
  for (const Vector2& position : map.positions)
    drawStroke(image, layout.at(position), layout.at(position), map.positions.size() > 1 ? 2.0 : 8.0, kPosition);
  drawText(image, map.title, kMargin, (kMargin - kTextScale * kGlyphHeight) / 2, kTextScale, kInk);
  const double bottom = layout.height - 0.5 * kMargin;
  drawStroke(image, {kMargin, bottom}, {kMargin + layout.scale * layout.bar, bottom}, 2.0, kInk);
  drawText(image, barText(layout.bar), kMargin + static_cast<int>(layout.scale * layout.bar) + 8,
           static_cast<int>(bottom) - kGlyphHeight, kTextScale, kInk);
  return image;
}

std::string mapSvg(const LineMap& map) {
  const Layout layout = layOut(map);
  const std::string size = std::to_string(layout.width) + " " + std::to_string(layout.height);
  std::string text =
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + size + "\" width=\"" + std::to_string(layout.width) +
      "\" height=\"" + std::to_string(layout.height) + "\">\n" +
      "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n<g fill=\"none\" stroke-linecap=\"round\">\n";
  const auto stroke = [](const Rgb& color, double width) {
    return "stroke=\"" + colorText(color) + "\" stroke-width=\"" + number(width) + "\"";
  };
  const auto dots = [&](const std::vector<Vector2>& points, const Rgb& color, double width) {
    text += "<path " + stroke(color, width) + " d=\"";
    for (const auto& [x, y] : pixelsOf(points, layout))
      text += "M" + std::to_string(x) + " " + std::to_string(y) + "h0";
    text += "\"/>\n";
  };
  const auto line = [&](const Vector2& from, const Vector2& to, const std::string& look) {
    text += "<path " + look + " d=\"M" + number(from.x()) + " " + number(from.y()) + "L" + number(to.x()) + " " +
            number(to.y()) + "\"/>\n";
  };
  dots(map.points, kPoint, map.points.size() > 5000 ? 1.0 : 3.0);
  for (const LineMap::Segment& segment : map.segments)
    line(layout.at(segment.start), layout.at(segment.end), stroke(segment.color, map.segment_width));
  dots(map.positions, kPosition, map.positions.size() > 1 ? 2.0 : 8.0);
  const double bottom = layout.height - 0.5 * kMargin, end = kMargin + layout.scale * layout.bar;
  line({kMargin, bottom}, {end, bottom}, stroke(kInk, 2.0));
  text += "</g>\n<g font-family=\"sans-serif\" font-size=\"16\" fill=\"" + colorText(kInk) + "\">\n<text x=\"" +
          number(kMargin) + "\" y=\"" + number(0.65 * kMargin) + "\">" + escaped(map.title) + "</text>\n<text x=\"" +
          number(end + 8) + "\" y=\"" + number(bottom + 5) + "\">" + number(layout.bar) + " m</text>\n</g>\n</svg>\n";
  return text;
}

}  // namespace epcc
