// SPDX-License-Identifier: BSD-3-Clause
// The median of many times in memory that does not grow with their number.
#pragma once

#include <map>
#include <optional>

namespace epcc {

/// Times in whole microseconds, counted by value: what the reports show, and no more values than the times are spread.
class TimeCounts {
 public:
  void add(double ms);
  std::optional<double> medianMs() const;
  TimeCounts& operator+=(const TimeCounts& other);

 private:
  long valueAt(long rank) const;

  std::map<long, long> counts_;
  long total_ = 0;
};

}  // namespace epcc
