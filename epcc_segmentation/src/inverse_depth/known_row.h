// SPDX-License-Identifier: BSD-3-Clause
// Samples of one row ask the planes that they are expected to be part of.
#pragma once

#include <cstddef>
#include <cstdint>

namespace epcc {

/// Samples that are looked at together: most of them expect the same plane.
constexpr int kKnownBlock = 16;

/// A plane as it is expected in the frame: w = x across + y along + z.
struct KnownRowPlane {
  float x = 0.0f, y = 0.0f, z = 0.0f;
  float max_square = -1.0f;  ///< of a residual, times its weight; none is below 0
};

/// Samples of a row.
struct KnownRow {
  const float* w;
  const float* weight;
  const float* across;
  float along;
  int count;
};

/// Samples without a label take the one that they expect, where their depth agrees with its plane: labels[k] =
/// expected[k]. 0 and less are none. Returns how many have got one.
std::size_t takeExpected(const KnownRow& row, const KnownRowPlane* planes, const std::int32_t* expected,
                         std::int32_t* labels);

}  // namespace epcc
