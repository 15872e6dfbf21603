// SPDX-License-Identifier: BSD-3-Clause
// The median is found by walking over the counts in the order of the values.
#include "eval/experiment/time_counts.h"

#include <cmath>

namespace epcc {

void TimeCounts::add(double ms) {
  ++counts_[std::lround(1e3 * ms)];
  ++total_;
}

long TimeCounts::valueAt(long rank) const {
  long passed = 0;
  for (const auto& [microseconds, count] : counts_) {
    passed += count;
    if (passed > rank) return microseconds;
  }
  return 0;
}

std::optional<double> TimeCounts::medianMs() const {
  if (total_ == 0) return std::nullopt;
  return 0.5e-3 * static_cast<double>(valueAt((total_ - 1) / 2) + valueAt(total_ / 2));
}

TimeCounts& TimeCounts::operator+=(const TimeCounts& other) {
  for (const auto& [microseconds, count] : other.counts_) counts_[microseconds] += count;
  total_ += other.total_;
  return *this;
}

}  // namespace epcc
