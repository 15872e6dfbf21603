// SPDX-License-Identifier: BSD-3-Clause
// What a plane fit to a block leaves of an error with correlation exp(-r^2 / (2 l^2)), and the blotches that explain
// what was left.
#pragma once

#include <array>
#include <vector>

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
  double kept = 1.0;    ///< share of the blotches' variance that the fits to the blocks do not absorb

  /// Standard deviation of the error over that of the residuals in the blocks.
  double errorOverResidual() const;
};

/// What blocks of one size leave of blotches of all lengths that they can tell apart, found once and for all.
class BlotchTable {
 public:
  explicit BlotchTable(int block_size);
  /// Least squares on the correlation of the residuals beyond lag 1; up to a third of the block in length.
  Blotches fit(const std::array<double, kLags.size()>& correlation) const;

 private:
  struct Entry {
    double length;
    FittedBlotches fitted;
  };
  std::vector<Entry> entries_;
};

/// Of the two sizes that are measured, 16 and 32 pixels.
const BlotchTable& blotchTable(int block_size);

}  // namespace epcc
