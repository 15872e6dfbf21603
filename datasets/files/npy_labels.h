// SPDX-License-Identifier: BSD-3-Clause
// NumPy label arrays, the way EVOPS distributes plane labels.
#pragma once

#include <string>

#include "datasets/files/image.h"

namespace epcc {

/// Reads an array of shape (height, width) or (height * width), row-major, little-endian, of integers or floats whose
/// values are whole: 0 no plane, 1..65534 plane, 65535 ignore. Everything else is an InputError.
LabelImage readNpyLabels(const std::string& path, int width, int height);

}  // namespace epcc
