// SPDX-License-Identifier: BSD-3-Clause
// 16-bit grey and label PNG in, 16-bit grey and 8-bit RGB PNG out.
#pragma once

#include <string>

#include "datasets/files/image.h"

namespace epcc {

/// Reads a 16-bit greyscale PNG, values as stored (no gamma, no scaling). Anything else is an InputError.
Image<std::uint16_t> readGray16(const std::string& path);

/// Reads a label picture of another program: grey of 8 or 16 bits or a palette's indices as they are (0 = no plane,
/// 65535 = ignore), or 8-bit RGB, where each colour is a plane, numbered from 1, and black and white are none.
LabelImage readLabelPng(const std::string& path);

/// Writes atomically; OutputError on failure.
void writeGray16(const std::string& path, const Image<std::uint16_t>& image);
void writeRgb(const std::string& path, const ColorImage& image);

}  // namespace epcc
