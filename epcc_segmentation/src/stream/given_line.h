// SPDX-License-Identifier: BSD-3-Clause
// What the steps of a stream pass on: a scan line, not segmented yet.
#pragma once

#include <cstddef>
#include <cstdint>

namespace epcc {

/// A scan line as it came: depths, ranges at an azimuth, or points.
struct GivenLine {
  std::int64_t index = 0;
  double azimuth = 0.0;
  const float* values = nullptr;
  std::ptrdiff_t stride = 1;  ///< floats
};

}  // namespace epcc
