// SPDX-License-Identifier: BSD-3-Clause
// A 5x7 bitmap font for captions in pictures.
#pragma once

#include <string>

#include "datasets/files/image.h"

namespace epcc {

/// Direction of a caption.
enum class TextDirection { Right, Up };

constexpr int kGlyphWidth = 5;
constexpr int kGlyphHeight = 7;

/// Length of a text in pixels: glyphs and the gaps between them.
int textLength(const std::string& text, int scale);

/// Draws a text. (x, y) is its first pixel: the upper left corner of a text running right, the lower left corner
/// of one running up. Letters are drawn as capitals, characters without a glyph as a space; pixels outside the
/// image are dropped.
void drawText(ColorImage& image, const std::string& text, int x, int y, int scale, const Rgb& color,
              TextDirection direction = TextDirection::Right);

}  // namespace epcc
