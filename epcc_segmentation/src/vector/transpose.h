// SPDX-License-Identifier: BSD-3-Clause
// Rows of an image side by side, so that every lane of a vector walks along a row of its own, and back.
#pragma once

#include <cstddef>
#include <cstdint>

namespace epcc {

/// to[column * to_pitch + row] = from[row * from_pitch + column]; pitches are in values.
void transpose(const float* from, std::size_t from_pitch, int rows, int columns, float* to, std::size_t to_pitch);
void transpose(const std::int32_t* from, std::size_t from_pitch, int rows, int columns, std::int32_t* to,
               std::size_t to_pitch);

}  // namespace epcc
