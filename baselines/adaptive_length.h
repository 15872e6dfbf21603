// SPDX-License-Identifier: BSD-3-Clause
// Lengths that are given in metres or grow with the distance of the scene.
#pragma once

#include <cmath>
#include <string>

namespace epcc {

/// A length of a baseline: fixed, as in the paper's Table 3, or in proportion to the median distance of the measured
/// points, so that one set of parameters serves a desk at half a metre and a corridor of ten.
struct AdaptiveLength {
  double metres = 0.0;     ///< Fixed length, (0, 100] m; used where per_metre is 0.
  double per_metre = 0.0;  ///< Length per metre of median distance, [0, 1]; 0: fixed.

  /// The length for a scene at this median distance in metres.
  double at(double median_distance) const { return per_metre > 0.0 ? per_metre * median_distance : metres; }

  /// Empty if usable, else what is wrong with the length called `name`, in words.
  std::string validate(const std::string& name) const {
    if (!(per_metre >= 0.0 && per_metre <= 1.0)) return name + " per metre must be in [0, 1]";
    if (per_metre == 0.0 && !(metres > 0.0 && metres <= 100.0)) return name + " must be in (0, 100] m";
    return {};
  }
};

}  // namespace epcc
