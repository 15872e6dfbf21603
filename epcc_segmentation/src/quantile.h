// SPDX-License-Identifier: BSD-3-Clause
// Order statistics of a few numbers.
#pragma once

#include <algorithm>
#include <cassert>
#include <vector>

namespace epcc {

/// The value below which `share` of the values lie; not for an empty list. Reorders them.
template <typename Scalar>
Scalar quantile(std::vector<Scalar>& values, double share) {
  assert(!values.empty() && share >= 0.0 && share <= 1.0);
  const auto at = values.begin() + static_cast<long>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// The middle one, of an even number the larger of the two; not for an empty list. Reorders them.
template <typename Scalar>
Scalar median(std::vector<Scalar>& values) {
  assert(!values.empty());
  const auto at = values.begin() + static_cast<long>(values.size() / 2);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

}  // namespace epcc
