// SPDX-License-Identifier: BSD-3-Clause
// The range of depths that a caller wants, of depth images and clouds alike.
#pragma once

namespace epcc {

constexpr const char* kNoDepthRange = "the depths must be 0 <= min_depth < max_depth";

/// False also where one of them is no number.
constexpr bool isDepthRange(double min_depth, double max_depth) {
  return min_depth >= 0.0 && max_depth > min_depth;
}

}  // namespace epcc
