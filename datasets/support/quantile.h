// SPDX-License-Identifier: BSD-3-Clause
// Order statistics of the readers, measures and reports; their one definition of a median.
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace epcc {

/// The value of this rank, 0 the smallest; not for an empty list. Reorders its copy.
template <typename Number>
Number valueOfRank(std::vector<Number> values, std::size_t rank) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(std::min(rank, values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// The value of rank share * (n - 1), rounded down, for a share from 0 to 1; not for an empty list.
template <typename Number>
Number quantile(std::vector<Number> values, double share) {
  const auto rank = static_cast<std::size_t>(share * static_cast<double>(values.size() - 1));
  return valueOfRank(std::move(values), rank);
}

/// The middle value, of an even number of values the mean of the middle two; 0 for none.
inline double median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const auto upper = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), upper, values.end());
  if (values.size() % 2 == 1) return *upper;
  return 0.5 * (*std::max_element(values.begin(), upper) + *upper);
}

}  // namespace epcc
