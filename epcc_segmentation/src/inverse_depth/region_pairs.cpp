// SPDX-License-Identifier: BSD-3-Clause
// The table of pairs grows by doubling.
#include "inverse_depth/region_pairs.h"

namespace epcc {

namespace {

constexpr int kFirstBits = 12;  // of the table's size

}  // namespace

RegionPairTable::RegionPairTable() {
  resize(kFirstBits);
}

// A table that one crowded frame has made large costs the frames after it little: only what was filled is freed, the
// last first, so that a search never ends at a place that was taken when its key came.
void RegionPairTable::clear() {
  for (auto entry = filled_.rbegin(); entry != filled_.rend(); ++entry) entries_[find(entry->key)].key = 0;
  filled_.clear();
  pairs_.clear();
}

void RegionPairTable::assign(const RegionPair& pair, int number) {
  fill(find(keyOf(pair)), {keyOf(pair), number});
}

int RegionPairTable::insert(std::size_t place, const RegionPair& pair) {
  const auto number = static_cast<std::int32_t>(pairs_.size());
  pairs_.push_back(pair);
  fill(place, {keyOf(pair), number});
  return number;
}

// Where memory runs out, what is in the table is on the list.
void RegionPairTable::fill(std::size_t place, const Entry& entry) {
  filled_.push_back(entry);
  entries_[place] = entry;
  if (4 * filled_.size() > entries_.size()) resize(64 - shift_ + 1);
}

void RegionPairTable::makeRoom(std::size_t pairs) {
  filled_.reserve(pairs);
  pairs_.reserve(pairs);
  while (4 * pairs > entries_.size()) resize(64 - shift_ + 1);
}

void RegionPairTable::resize(int bits) {
  std::vector<Entry>(std::size_t{1} << bits).swap(entries_);
  shift_ = 64 - bits;
  for (const Entry& entry : filled_) entries_[find(entry.key)] = entry;
}

}  // namespace epcc
