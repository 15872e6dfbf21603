// SPDX-License-Identifier: BSD-3-Clause
// A row of a depth image -> metres, in vectors.
#pragma once

#include <cstddef>
#include <cstdint>

namespace epcc {

/// z = scale * value; 0 where that is not positive and finite, or the integer is 65535.
void depthsInMetres(const std::uint16_t* values, std::size_t count, double scale, float* depth);
void depthsInMetres(const float* values, std::size_t count, double scale, float* depth);

}  // namespace epcc
