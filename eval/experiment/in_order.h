// SPDX-License-Identifier: BSD-3-Clause
// Records that come in any order, handed on in that of the jobs.
#pragma once

#include <cstddef>
#include <map>
#include <mutex>
#include <utility>
#include <vector>

#include "eval/experiment/experiment.h"

namespace epcc {

/// Keeps what came too early. Several threads may add at once.
class InOrder {
 public:
  explicit InOrder(const FrameInOrder& next) : next_(next) {}
  void add(std::size_t index, std::vector<FrameRecord> records) {
    const std::lock_guard<std::mutex> lock(mutex_);
    waiting_[index] = std::move(records);
    for (auto first = waiting_.begin(); first != waiting_.end() && first->first == due_; ++due_) {
      if (next_) next_(first->second);
      first = waiting_.erase(first);
    }
  }

 private:
  const FrameInOrder& next_;
  std::mutex mutex_;
  std::map<std::size_t, std::vector<FrameRecord>> waiting_;
  std::size_t due_ = 0;
};

}  // namespace epcc
