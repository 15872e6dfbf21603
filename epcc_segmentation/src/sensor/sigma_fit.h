// SPDX-License-Identifier: BSD-3-Clause
// The sensor model sigma_z(z) = sqrt(a^2 + b^2 z^4) that fits a few depths, whatever the unit of length.
#pragma once

#include <utility>
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

/// sigma = S sqrt(cos^2 phi + sin^2 phi (z/z0)^4), z0 the mean depth, best by a quantile of the logarithm: below the
/// median, for clutter only enlarges the targets. What the depths do not tell is left half and half. Keeps its memory.
class SigmaFitter {
 public:
  explicit SigmaFitter(std::size_t most_targets) { ratios_.reserve(most_targets); }
  /// Both 0 if there is no target.
  SigmaFit fit(const std::vector<SigmaTarget>& targets);

 private:
  std::vector<std::pair<double, double>> ratios_;  // ln of target over shape, weight
};

}  // namespace epcc
