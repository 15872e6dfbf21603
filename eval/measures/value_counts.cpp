// SPDX-License-Identifier: BSD-3-Clause
// The median is found by walking over the counts in the order of the values.
#include "eval/measures/value_counts.h"

namespace epcc {

void ValueCounts::add(long value) {
  ++counts_[value];
  ++total_;
}

long ValueCounts::valueAt(long rank) const {
  long passed = 0;
  for (const auto& [value, count] : counts_) {
    passed += count;
    if (passed > rank) return value;
  }
  return 0;
}

std::optional<double> ValueCounts::median() const {
  if (total_ == 0) return std::nullopt;
  return 0.5 * static_cast<double>(valueAt((total_ - 1) / 2) + valueAt(total_ / 2));
}

ValueCounts& ValueCounts::operator+=(const ValueCounts& other) {
  for (const auto& [value, count] : other.counts_) counts_[value] += count;
  total_ += other.total_;
  return *this;
}

}  // namespace epcc
