// SPDX-License-Identifier: BSD-3-Clause
// Lays pictures out in a grid.
#include "eval/pictures/mosaic.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "eval/pictures/bitmap_font.h"

namespace epcc {
namespace {

int scaledHeight(const ColorImage& image, int width) {
  if (image.empty()) return 0;
  return std::max(1, static_cast<int>(std::lround(static_cast<double>(image.height) * width / image.width)));
}

// Mean colour of the source pixels [x0, x1) x [y0, y1).
Rgb meanColor(const ColorImage& image, int x0, int x1, int y0, int y1) {
  long sum[3] = {0, 0, 0};
  for (int y = y0; y < y1; ++y) {
    for (int x = x0; x < x1; ++x) {
      const Rgb& pixel = image.data[static_cast<std::size_t>(y) * image.width + x];
      sum[0] += pixel.r;
      sum[1] += pixel.g;
      sum[2] += pixel.b;
    }
  }
  const long count = static_cast<long>(x1 - x0) * (y1 - y0);
  const auto mean = [count](long total) { return static_cast<std::uint8_t>((total + count / 2) / count); };
  return Rgb{mean(sum[0]), mean(sum[1]), mean(sum[2])};
}

// First source pixel of target pixel i.
int sourceStart(int i, int source_size, int target_size) {
  return static_cast<int>(static_cast<long>(i) * source_size / target_size);
}

void paste(const ColorImage& source, int x, int y, ColorImage& target) {
  for (int row = 0; row < source.height; ++row) {
    const auto from = source.data.begin() + static_cast<std::ptrdiff_t>(row) * source.width;
    std::copy(from, from + source.width, target.data.begin() + static_cast<std::ptrdiff_t>(y + row) * target.width + x);
  }
}

struct Layout {
  int left;  // of the first column
  int top;   // of the first row
  std::vector<int> row_heights;
  std::size_t columns;

  int x(std::size_t column, const MosaicStyle& style) const {
    return left + static_cast<int>(column) * (style.cell_width + style.gap);
  }
  int width(const MosaicStyle& style) const { return x(columns, style); }
  int height(const MosaicStyle& style) const {
    int total = top;
    for (const int height : row_heights) total += height + style.gap;
    return total;
  }
};

Layout layOut(const Mosaic& mosaic, const MosaicStyle& style) {
  const int caption = kGlyphHeight * style.text_scale + style.gap;
  Layout layout{style.gap, style.gap, {}, mosaic.column_captions.size()};
  if (!mosaic.row_captions.empty()) layout.left += caption;
  if (!mosaic.column_captions.empty()) layout.top += caption;
  for (const std::vector<ColorImage>& row : mosaic.rows) {
    int height = 1;
    for (const ColorImage& image : row) height = std::max(height, scaledHeight(image, style.cell_width));
    layout.row_heights.push_back(height);
    layout.columns = std::max(layout.columns, row.size());
  }
  return layout;
}

void drawColumnCaptions(const Mosaic& mosaic, const MosaicStyle& style, const Layout& layout, ColorImage& canvas) {
  for (std::size_t i = 0; i < mosaic.column_captions.size(); ++i) {
    const std::string& text = mosaic.column_captions[i];
    const int indent = std::max(0, (style.cell_width - textLength(text, style.text_scale)) / 2);
    drawText(canvas, text, layout.x(i, style) + indent, style.gap, style.text_scale, style.text);
  }
}

void drawRow(const std::vector<ColorImage>& row, int y, const MosaicStyle& style, const Layout& layout,
             ColorImage& canvas) {
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (row[i].empty()) continue;
    paste(resize(row[i], style.cell_width, scaledHeight(row[i], style.cell_width)), layout.x(i, style), y, canvas);
  }
}

}  // namespace

ColorImage resize(const ColorImage& image, int width, int height) {
  ColorImage result(width, height);
  for (int y = 0; y < height; ++y) {
    const int y0 = sourceStart(y, image.height, height);
    const int y1 = std::max(y0 + 1, sourceStart(y + 1, image.height, height));
    for (int x = 0; x < width; ++x) {
      const int x0 = sourceStart(x, image.width, width);
      const int x1 = std::max(x0 + 1, sourceStart(x + 1, image.width, width));
      result.data[static_cast<std::size_t>(y) * width + x] = meanColor(image, x0, x1, y0, y1);
    }
  }
  return result;
}

ColorImage drawMosaic(const Mosaic& mosaic, const MosaicStyle& style) {
  if (style.cell_width < 1 || style.gap < 0 || style.text_scale < 1) {
    throw std::invalid_argument("mosaic: cell width and text scale must be at least 1, the gap at least 0");
  }
  const Layout layout = layOut(mosaic, style);
  ColorImage canvas(layout.width(style), layout.height(style), style.background);
  drawColumnCaptions(mosaic, style, layout, canvas);
  int y = layout.top;
  for (std::size_t i = 0; i < mosaic.rows.size(); ++i) {
    if (i < mosaic.row_captions.size()) {
      const int slack = layout.row_heights[i] - textLength(mosaic.row_captions[i], style.text_scale);
      drawText(canvas, mosaic.row_captions[i], style.gap, y + layout.row_heights[i] - 1 - std::max(0, slack / 2),
               style.text_scale, style.text, TextDirection::Up);
    }
    drawRow(mosaic.rows[i], y, style, layout, canvas);
    y += layout.row_heights[i] + style.gap;
  }
  return canvas;
}

}  // namespace epcc
