// SPDX-License-Identifier: BSD-3-Clause
// The few first of many, in any order of arrival.
#pragma once

#include <cstddef>
#include <map>
#include <utility>

namespace epcc {

/// Keeps the `most` values with the smallest keys; no two keys may be equal.
template <typename Key, typename Value>
class Foremost {
 public:
  explicit Foremost(std::size_t most) : most_(most) {}
  void add(const Key& key, const Value& value) {
    if (most_ == 0 || (kept_.size() == most_ && !(key < std::prev(kept_.end())->first))) return;
    kept_.emplace(key, value);
    if (kept_.size() > most_) kept_.erase(std::prev(kept_.end()));
  }
  const std::map<Key, Value>& kept() const { return kept_; }

 private:
  std::size_t most_;
  std::map<Key, Value> kept_;
};

}  // namespace epcc
