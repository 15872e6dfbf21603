// SPDX-License-Identifier: BSD-3-Clause
// 16-bit grey PNG in, 16-bit grey and 8-bit RGB PNG out.
#pragma once

#include <string>

#include "datasets/image.h"

namespace epcc {

/// Reads a 16-bit greyscale PNG, values as stored (no gamma, no scaling). Anything else is an InputError.
Image<std::uint16_t> readGray16(const std::string& path);

/// Writes atomically; OutputError on failure.
void writeGray16(const std::string& path, const Image<std::uint16_t>& image);
void writeRgb(const std::string& path, const ColorImage& image);

}  // namespace epcc
