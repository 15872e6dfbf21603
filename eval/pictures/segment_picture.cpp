// SPDX-License-Identifier: BSD-3-Clause
// Colours the pixels of the line segments.
#include "eval/pictures/segment_picture.h"

#include <stdexcept>

#include "eval/pictures/label_colors.h"
#include "eval/pictures/overlay.h"

namespace epcc {
namespace {

constexpr int kStep = 6;     // at least, between scan lines: drawn side by side the segments would be an overlay
constexpr int kDimming = 2;  // of the relief, so that thin lines stand out
constexpr Rgb kEnd{18, 18, 22};
constexpr Rgb kNoPlane[] = {{255, 255, 255}, {0, 0, 0}};

Rgb dimmed(const Rgb& color) {
  const auto dim = [](std::uint8_t value) { return static_cast<std::uint8_t>(value / kDimming); };
  return {dim(color.r), dim(color.g), dim(color.b)};
}

bool isInside(const DepthImage& depth, const LineSegment& segment) {
  const auto inside = [&](int row, int column) {
    return row >= 0 && row < depth.height && column >= 0 && column < depth.width;
  };
  return segment.first <= segment.last && inside(segment.row(segment.first), segment.column(segment.first)) &&
         inside(segment.row(segment.last), segment.column(segment.last));
}

}  // namespace

ColorImage drawSegments(const DepthImage& depth, const std::vector<LineSegment>& segments) {
  ColorImage image = shadeDepth(depth);
  for (Rgb& pixel : image.data) pixel = dimmed(pixel);
  std::size_t turn = 0;
  const LineSegment* drawn = nullptr;  // the last; a grid has any of the scan lines, so that none is always there
  for (const LineSegment& segment : segments) {
    if (!isInside(depth, segment)) throw std::invalid_argument("a line segment lies outside the image");
    const bool beside = drawn != nullptr && drawn->scan == segment.scan && drawn->line != segment.line &&
                        segment.line < drawn->line + kStep;
    if (beside) continue;
    drawn = &segment;
    const Rgb color = segment.label > 0 ? labelColor(segment.label) : kNoPlane[turn++ % 2];
    for (int i = segment.first; i < segment.last; ++i) image.at(segment.row(i), segment.column(i)) = color;
    image.at(segment.row(segment.last), segment.column(segment.last)) = kEnd;
  }
  return image;
}

}  // namespace epcc
