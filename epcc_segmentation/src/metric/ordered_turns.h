// SPDX-License-Identifier: BSD-3-Clause
// Lets threads finish parts of a job in any order and hands them on one after another in theirs.
#pragma once

#include <mutex>
#include <vector>

namespace epcc {

/// Parts 0, 1, ... that are finished by several threads and taken in order, by one thread at a time.
class OrderedTurns {
 public:
  void begin(int count) {
    finished_.assign(static_cast<std::size_t>(count), 0);
    next_ = 0;
    is_busy_ = false;
  }
  /// A part is finished: calls take(part) for all whose turn it is, unless another thread is at that, which then takes
  /// this part, too.
  template <typename Take>
  void finish(int part, const Take& take) {
    std::unique_lock<std::mutex> lock(mutex_);
    finished_[static_cast<std::size_t>(part)] = 1;
    if (is_busy_) return;
    is_busy_ = true;
    while (next_ < static_cast<int>(finished_.size()) && finished_[static_cast<std::size_t>(next_)] != 0) {
      const int turn = next_++;
      lock.unlock();
      take(turn);
      lock.lock();
    }
    is_busy_ = false;
  }
  /// How many parts have been taken.
  int taken() const { return next_; }

 private:
  std::mutex mutex_;
  std::vector<char> finished_;
  int next_ = 0;
  bool is_busy_ = false;
};

}  // namespace epcc
