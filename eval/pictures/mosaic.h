// SPDX-License-Identifier: BSD-3-Clause
// Pictures side by side in a grid with captions, as in the paper's Figure 21 (rows of scenes, columns of methods).
#pragma once

#include <string>
#include <vector>

#include "datasets/files/image.h"

namespace epcc {

/// What is shown. Rows may differ in length; an empty picture leaves its cell blank. Captions may be missing.
struct Mosaic {
  std::vector<std::string> column_captions;
  std::vector<std::string> row_captions;
  std::vector<std::vector<ColorImage>> rows;
};

/// How it looks.
struct MosaicStyle {
  /// Pixels; a picture is scaled to fit, keeping its shape. A row is as high as its highest picture.
  int cell_width = 320;
  int gap = 6;
  /// Pixels of the screen a pixel of the 5x7 font takes.
  int text_scale = 2;
  Rgb background{255, 255, 255};
  Rgb text{20, 20, 20};
};

/// Scales to the given size: mean over the covered area when smaller, nearest pixel when larger.
ColorImage resize(const ColorImage& image, int width, int height);

/// Draws the grid. Throws std::invalid_argument for a cell width below 1 or a negative gap.
ColorImage drawMosaic(const Mosaic& mosaic, const MosaicStyle& style = MosaicStyle());

}  // namespace epcc
