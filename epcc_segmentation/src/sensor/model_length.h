// SPDX-License-Identifier: BSD-3-Clause
// The correlation length that a sensor model is given, from that of the measured error.
#pragma once

namespace epcc {

constexpr double kLengthOfGrain = 0.4;  ///< pixels, effective length of an error that differs from pixel to pixel

/// In proportion to the length of the error, beside that of grain; pixels.
constexpr double lengthOfError(double effective_length) {
  return 1.5 * effective_length + kLengthOfGrain;
}

}  // namespace epcc
