// SPDX-License-Identifier: BSD-3-Clause
// Polygons are filled row by row with the depth of their plane; the nearest stays.
#include "eval/track/map_picture.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>

#include "eval/pictures/bitmap_font.h"
#include "eval/pictures/label_colors.h"
#include "eval/pictures/mosaic.h"
#include "eval/pictures/plot_axis.h"

namespace epcc {
namespace {

constexpr Rgb kPaper{255, 255, 255}, kInk{30, 30, 30};
constexpr int kPictureMargin = 24;
constexpr double kFacing = 0.08;          // least cosine between a surface's normal and the view
constexpr double kLabelledShare = 0.004;  // of the picture, of a surface that carries its label
constexpr int kViewWidth = 900;

/// Where the map is in the picture.
struct Frame {
  MapView view;
  Eigen::Vector2d low;  // metres
  double scale = 1.0;   // pixels a metre
  int height = 0;
  Eigen::Vector2d metres(const Eigen::Vector3d& point) const { return {view.right.dot(point), view.up.dot(point)}; }
  Eigen::Vector2d pixel(const Eigen::Vector3d& point) const {
    const Eigen::Vector2d from_low = scale * (metres(point) - low);
    return {kPictureMargin + from_low.x(), height - 1 - kPictureMargin - from_low.y()};
  }
};

struct Canvas {
  ColorImage image;
  Image<float> nearest;  // metres towards the viewer
  Image<int> label;
};

bool isShown(const MappedTrack& one, const MapView& view) {
  return one.track.end == TrackEnd::None && !one.surface.pieces.empty() &&
         view.out.dot(Eigen::Vector3d(one.surface.basis.normal)) > kFacing;
}

Frame frameOf(const std::vector<MappedTrack>& tracks, const Trajectory& trajectory, const MapView& view, int width) {
  Frame frame;
  frame.view = view;
  Eigen::Vector2d low(1e300, 1e300), high = -low;
  const auto take = [&](const Eigen::Vector3d& point) {
    low = low.cwiseMin(frame.metres(point));
    high = high.cwiseMax(frame.metres(point));
  };
  for (const MappedTrack& one : tracks)
    if (isShown(one, view))
      for (const SurfacePiece& piece : one.surface.pieces)
        for (const Vector3& point : piece.outline.points) take(point);
  for (const StampedPose& stamped : trajectory) take(stamped.pose.translation());
  if (low.x() > high.x()) low = high = Eigen::Vector2d::Zero();
  const Eigen::Vector2d size = (high - low).cwiseMax(1e-3);
  frame.scale = std::min((width - 2 * kPictureMargin) / size.x(), (2.0 * width - 2 * kPictureMargin) / size.y());
  frame.height = static_cast<int>(std::ceil(frame.scale * size.y())) + 2 * kPictureMargin + 3 * kGlyphHeight;
  frame.low = low;
  frame.low.y() -= 2.5 * kGlyphHeight / frame.scale;  // room for the bar
  return frame;
}

Rgb shaded(const Rgb& color, double brightness) {
  const auto of = [&](std::uint8_t value) {
    return static_cast<std::uint8_t>(
        std::lround(std::clamp(brightness * value + (1.0 - brightness) * 40.0, 0.0, 255.0)));
  };
  return {of(color.r), of(color.g), of(color.b)};
}

/// Where a row meets the sides of a surface's rings, in order.
std::vector<double> crossings(const SurfacePolygon& surface, const Frame& frame, double row) {
  std::vector<double> columns;
  const auto cross = [&](const SurfaceRing& ring) {
    for (std::size_t i = 0; i < ring.points.size(); ++i) {
      const Eigen::Vector2d a = frame.pixel(ring.points[i]), b = frame.pixel(ring.points[(i + 1) % ring.points.size()]);
      if ((a.y() <= row) == (b.y() <= row)) continue;
      columns.push_back(a.x() + (row - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
    }
  };
  for (const SurfacePiece& piece : surface.pieces) {
    cross(piece.outline);
    for (const SurfaceRing& hole : piece.holes) cross(hole);
  }
  std::sort(columns.begin(), columns.end());
  return columns;
}

void fill(const MappedTrack& one, const Frame& frame, Canvas& canvas) {
  const MapView& view = frame.view;
  const Eigen::Vector4d plane = one.track.plane.coefficients;
  const Eigen::Vector3d normal = plane.head<3>();
  const double facing = normal.dot(view.out);
  const Rgb color = shaded(labelColor(one.track.label), 0.55 + 0.45 * facing);
  double top = 1e300, bottom = -1e300;
  for (const SurfacePiece& piece : one.surface.pieces)
    for (const Vector3& point : piece.outline.points) {
      top = std::min(top, frame.pixel(point).y());
      bottom = std::max(bottom, frame.pixel(point).y());
    }
  const int first = std::max(0, static_cast<int>(std::ceil(top)));
  const int last = std::min(canvas.image.height - 1, static_cast<int>(std::floor(bottom)));
  for (int row = first; row <= last; ++row) {
    const std::vector<double> columns = crossings(one.surface, frame, row);
    const double y = frame.low.y() + (frame.height - 1 - kPictureMargin - row) / frame.scale;
    for (std::size_t k = 0; k + 1 < columns.size(); k += 2) {
      const int from = std::max(0, static_cast<int>(std::ceil(columns[k])));
      const int to = std::min(canvas.image.width - 1, static_cast<int>(std::floor(columns[k + 1])));
      for (int column = from; column <= to; ++column) {
        const double x = frame.low.x() + (column - kPictureMargin) / frame.scale;
        const auto out =
            static_cast<float>(-(plane(3) + x * normal.dot(view.right) + y * normal.dot(view.up)) / facing);
        if (out <= canvas.nearest.at(row, column)) continue;
        canvas.nearest.at(row, column) = out;
        canvas.image.at(row, column) = color;
        canvas.label.at(row, column) = one.track.label;
      }
    }
  }
}

/// Dark pixels where another surface begins.
void drawBorders(Canvas& canvas) {
  for (int row = 0; row + 1 < canvas.image.height; ++row)
    for (int column = 0; column + 1 < canvas.image.width; ++column) {
      const int here = canvas.label.at(row, column);
      if (here != canvas.label.at(row, column + 1) || here != canvas.label.at(row + 1, column))
        canvas.image.at(row, column) = kInk;
    }
}

void drawDot(ColorImage& image, const Eigen::Vector2d& at, int radius, const Rgb& color) {
  const int x = static_cast<int>(std::lround(at.x())), y = static_cast<int>(std::lround(at.y()));
  for (int dy = -radius; dy <= radius; ++dy)
    for (int dx = -radius; dx <= radius; ++dx)
      if (dx * dx + dy * dy <= radius * radius && y + dy >= 0 && x + dx >= 0 && y + dy < image.height &&
          x + dx < image.width)
        image.at(y + dy, x + dx) = color;
}

void drawLine(ColorImage& image, const Eigen::Vector2d& from, const Eigen::Vector2d& to, int radius) {
  const int steps = std::max(1, static_cast<int>(std::ceil((to - from).norm())));
  for (int k = 0; k <= steps; ++k) drawDot(image, from + (to - from) * k / steps, radius, kInk);
}

/// Labels where most of a surface is visible, on its own colour.
void drawLabels(Canvas& canvas) {
  std::map<int, std::pair<Eigen::Vector2d, long>> middles;
  for (int row = 0; row < canvas.label.height; ++row)
    for (int column = 0; column < canvas.label.width; ++column) {
      if (canvas.label.at(row, column) == 0) continue;
      auto& [sum, count] =
          middles.emplace(canvas.label.at(row, column), std::pair(Eigen::Vector2d(0.0, 0.0), 0L)).first->second;
      sum += Eigen::Vector2d(column, row);
      ++count;
    }
  const double least = kLabelledShare * canvas.label.width * canvas.label.height;
  for (const auto& [label, middle] : middles) {
    if (static_cast<double>(middle.second) < least) continue;
    const Eigen::Vector2d at = middle.first / static_cast<double>(middle.second);
    const std::string text = std::to_string(label);
    drawText(canvas.image, text, static_cast<int>(at.x()) - textLength(text, 2) / 2,
             static_cast<int>(at.y()) - kGlyphHeight, 2, {0, 0, 0});
  }
}

void drawBar(ColorImage& image, double scale) {
  const double length = tickStep(2.0 * image.width / scale);
  const int y = image.height - kPictureMargin / 2;
  drawLine(image, {kPictureMargin, y}, {kPictureMargin + length * scale, y}, 1);
  char text[40];
  std::snprintf(text, sizeof text, "%g m", length);
  drawText(image, text, kPictureMargin, y - 2 * kGlyphHeight - 5, 2, kInk);
}

}  // namespace

ColorImage drawMap(const std::vector<MappedTrack>& tracks, const Trajectory& trajectory, const MapView& view,
                   int width) {
  const Frame frame = frameOf(tracks, trajectory, view, width);
  Canvas canvas{ColorImage(width, frame.height, kPaper),
                Image<float>(width, frame.height, -std::numeric_limits<float>::infinity()),
                Image<int>(width, frame.height)};
  for (const MappedTrack& one : tracks)
    if (isShown(one, view)) fill(one, frame, canvas);
  drawBorders(canvas);
  for (std::size_t i = 1; i < trajectory.size(); ++i)
    drawLine(canvas.image, frame.pixel(trajectory[i - 1].pose.translation()),
             frame.pixel(trajectory[i].pose.translation()), 1);
  if (!trajectory.empty()) drawDot(canvas.image, frame.pixel(trajectory.front().pose.translation()), 6, kInk);
  drawLabels(canvas);
  drawBar(canvas.image, frame.scale);
  return canvas.image;
}

ColorImage mapPicture(const std::vector<MappedTrack>& tracks, const Trajectory& trajectory) {
  const Eigen::Vector3d up = upwards(tracks, trajectory);
  Mosaic mosaic;
  mosaic.column_captions = {"from above", "obliquely"};
  mosaic.rows = {{drawMap(tracks, trajectory, viewFromAbove(up, trajectory), kViewWidth),
                  drawMap(tracks, trajectory, obliqueView(up, trajectory), kViewWidth)}};
  MosaicStyle style;
  style.cell_width = kViewWidth;
  return drawMosaic(mosaic, style);
}

}  // namespace epcc
