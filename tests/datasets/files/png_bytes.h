// SPDX-License-Identifier: BSD-3-Clause
// PNG files made byte by byte, right and wrong ones, without libpng.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/support/big_endian.h"

namespace epcc::test {

/// What goes into a PNG file. The defaults are a 16-bit grey picture.
struct PngRecipe {
  std::uint32_t width = 5;
  std::uint32_t height = 3;
  int bit_depth = 16;
  int color_type = 0;        ///< 0 grey, 2 RGB, 3 palette, 4 grey + alpha
  int interlace = 0;         ///< 1 Adam7
  std::string before_image;  ///< chunks between IHDR and IDAT
  std::string scan_lines;    ///< filter byte and samples of each row, not yet compressed
};

extern const std::string kPngSignature;

/// Length, type, data, CRC.
std::string pngChunk(const std::string& type, const std::string& data);
/// Signature, IHDR, before_image, one IDAT, IEND.
std::string pngBytes(const PngRecipe& recipe);

/// Rows of big-endian 16-bit samples behind filter byte 0.
std::string grayScanLines(const std::vector<std::uint16_t>& values, std::uint32_t width);
/// The same in the order of the seven passes of Adam7.
std::string adam7ScanLines(const std::vector<std::uint16_t>& values, std::uint32_t width);

/// A 5x3 grey picture with the values grayValues().
PngRecipe grayRecipe();
std::vector<std::uint16_t> grayValues();

/// Recomputes the CRC of every whole chunk, so that a damage reaches what lies behind the check.
void repairChecksums(std::string& png);

}  // namespace epcc::test
