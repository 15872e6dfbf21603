// SPDX-License-Identifier: BSD-3-Clause
// The median of many times.
#pragma once

#include <optional>

#include "eval/measures/value_counts.h"

namespace epcc {

/// Times in whole microseconds: what the reports show.
class TimeCounts {
 public:
  void add(double ms);
  std::optional<double> medianMs() const;
  TimeCounts& operator+=(const TimeCounts& other);

 private:
  ValueCounts microseconds_;
};

}  // namespace epcc
