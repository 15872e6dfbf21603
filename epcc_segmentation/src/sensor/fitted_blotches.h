// SPDX-License-Identifier: BSD-3-Clause
// What a plane fit to a block leaves of an error with correlation exp(-r^2 / (2 l^2)), and the blotches that explain
// what was left.
#pragma once

#include <array>

#include "sensor/block_residuals.h"

namespace epcc {

struct FittedBlotches {
  double kept = 1.0;                               ///< share of the variance that the fit does not absorb
  std::array<double, kLags.size()> correlation{};  ///< of the residuals, at kLags
};

/// Expectation over a block of `size` x `size` pixels for blotches of radius `length` pixels.
FittedBlotches fittedBlotches(double length, int size);

/// An error of blotches and of grain that differs from pixel to pixel.
struct Blotches {
  double length = 1.0;  ///< radius, pixels
  double share = 0.0;   ///< of the residuals' variance, the rest is grain
  int block_size = 0;   ///< of the blocks in which it was seen

  /// Standard deviation of the error over that of the residuals in the blocks.
  double errorOverResidual() const;
};

/// Least squares on the correlation of the residuals beyond lag 1; up to a third of the block in length.
Blotches fitBlotches(const std::array<double, kLags.size()>& correlation, int block_size);

}  // namespace epcc
