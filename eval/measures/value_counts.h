// SPDX-License-Identifier: BSD-3-Clause
// The median of many values in memory that does not grow with their number.
#pragma once

#include <map>
#include <optional>

namespace epcc {

/// Whole numbers counted by value: no more entries than the values are spread, and no sum depends on their order.
class ValueCounts {
 public:
  void add(long value);
  long size() const { return total_; }
  /// The middle value, of an even number of values the mean of the middle two; nothing for none.
  std::optional<double> median() const;
  ValueCounts& operator+=(const ValueCounts& other);

 private:
  long valueAt(long rank) const;

  std::map<long, long> counts_;
  long total_ = 0;
};

}  // namespace epcc
