// SPDX-License-Identifier: BSD-3-Clause
// Milliseconds in, milliseconds out.
#include "eval/experiment/time_counts.h"

#include <cmath>

namespace epcc {

void TimeCounts::add(double ms) {
  microseconds_.add(std::lround(1e3 * ms));
}

std::optional<double> TimeCounts::medianMs() const {
  const std::optional<double> median = microseconds_.median();
  return median ? std::optional<double>(1e-3 * *median) : std::nullopt;
}

TimeCounts& TimeCounts::operator+=(const TimeCounts& other) {
  microseconds_ += other.microseconds_;
  return *this;
}

}  // namespace epcc
