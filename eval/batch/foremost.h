// SPDX-License-Identifier: BSD-3-Clause
// The values with the smallest keys, of many that come in any order.
#pragma once

#include <cstddef>
#include <map>
#include <utility>

namespace epcc {

/// Keeps the values with the `max_count` smallest keys; no two keys may be equal.
template <typename Key, typename Value>
class Foremost {
 public:
  explicit Foremost(std::size_t max_count) : max_count_(max_count) {}
  void add(const Key& key, const Value& value) {
    if (max_count_ == 0 || (kept_.size() == max_count_ && !(key < std::prev(kept_.end())->first))) return;
    kept_.emplace(key, value);
    if (kept_.size() > max_count_) kept_.erase(std::prev(kept_.end()));
  }
  const std::map<Key, Value>& kept() const { return kept_; }

 private:
  std::size_t max_count_;
  std::map<Key, Value> kept_;
};

}  // namespace epcc
