// SPDX-License-Identifier: BSD-3-Clause
// Label pictures: grey of 8 and 16 bits, palettes, colours.
#include "datasets/files/png_io.h"
#include "tests/datasets/files/png_bytes.h"
#include "tests/fuzz/file_run.h"
#include "tests/fuzz/targets.h"

namespace epcc::fuzz {
namespace {

bool runLabelPng(const std::uint8_t* data, std::size_t size) {
  return takesFile(data, size, [](const std::string& path) {
    const LabelImage labels = readLabelPng(path);
    require(labels.width > 0 && labels.height > 0, "an image has pixels");
    require(labels.data.size() == static_cast<std::size_t>(labels.width) * static_cast<std::size_t>(labels.height),
            "sizes agree");
  });
}

/// 6x5 pixels of `samples` bytes each.
test::PngRecipe eightBits(int color_type, std::size_t samples) {
  test::PngRecipe recipe;
  recipe.width = 6;
  recipe.height = 5;
  recipe.bit_depth = 8;
  recipe.color_type = color_type;
  for (char row = 0; row < 5; ++row) recipe.scan_lines += std::string(1, '\0') + std::string(6 * samples, row);
  return recipe;
}

std::vector<std::string> labelPngSeeds() {
  test::PngRecipe palette = eightBits(3, 1);
  palette.before_image = test::pngChunk("PLTE", std::string(15, '\x40'));
  return {test::pngBytes(test::grayRecipe()), test::pngBytes(eightBits(0, 1)), test::pngBytes(eightBits(2, 3)),
          test::pngBytes(palette)};
}

}  // namespace

const FuzzTarget kLabelPng{runLabelPng, labelPngSeeds};

}  // namespace epcc::fuzz
