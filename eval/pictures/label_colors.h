// SPDX-License-Identifier: BSD-3-Clause
// A fixed palette: the same label has the same colour in every picture.
#pragma once

#include <cstdint>

#include "datasets/files/image.h"

namespace epcc {

/// Colour of a label: black for 0 (no plane), grey for kIgnoreLabel, else a colour that differs clearly from
/// those of the labels near it. Negative labels count as 0.
Rgb labelColor(std::int32_t label);

}  // namespace epcc
