// SPDX-License-Identifier: BSD-3-Clause
// The sensor model sigma_z(z) = sqrt(a^2 + b^2 z^4) that fits a few depths.
#pragma once

#include <array>
#include <vector>

namespace epcc {

struct SigmaTarget {
  double depth = 0.0;      ///< metres
  double log_sigma = 0.0;  ///< of what the model is to say there, metres
  double weight = 0.0;
};

struct SigmaFit {
  double a = 0.0;  ///< metres, see SensorModel::axial
  double b = 0.0;  ///< 1/m
};

/// Best on a grid of a and b, 0 and 32 values from 0.1 to 30 mm and per mille each, by a quantile of the logarithm:
/// below the median, for clutter only enlarges the targets. Both 0 if no target is finite.
SigmaFit fitSigma(const std::vector<SigmaTarget>& targets);

}  // namespace epcc
