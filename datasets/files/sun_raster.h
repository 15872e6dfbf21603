// SPDX-License-Identifier: BSD-3-Clause
// 8-bit Sun raster files, the pictures of the SegComp comparison.
#pragma once

#include <cstdint>
#include <string>

#include "datasets/files/image.h"

namespace epcc {

/// Reads an uncompressed 8-bit raster, values as stored; a colour map is skipped. Everything else is an InputError.
Image<std::uint8_t> readSunRaster(const std::string& path);

/// True if the file starts like a Sun raster; does not throw.
bool isSunRaster(const std::string& path);

/// Labels of a SegComp .gt-seg file: values from 10 are planes, below 10 are shadow, noise and edges: 0.
LabelImage readSegcompLabels(const std::string& path);

}  // namespace epcc
