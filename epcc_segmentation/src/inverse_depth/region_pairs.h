// SPDX-License-Identifier: BSD-3-Clause
// Numbers pairs of regions in the order of their first mention.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace epcc {

/// Two labels, low < high.
struct RegionPair {
  std::int32_t low, high;
  RegionPair(std::int32_t a, std::int32_t b) : low(a < b ? a : b), high(a < b ? b : a) {}
};

/// The numbers of pairs of labels that are not 0. A table with open addressing, at most a quarter full: its memory and
/// time grow with the pairs there are, not with the square of the regions, and on real frames it stays in the cache.
class RegionPairTable {
 public:
  RegionPairTable();
  /// Forgets all pairs. The memory is kept.
  void clear();

  /// For so many pairs.
  void makeRoom(std::size_t pairs);
  /// The number of a pair. A new pair gets the next one.
  int add(const RegionPair& pair) {
    const std::size_t place = find(keyOf(pair));
    return entries_[place].key == 0 ? insert(place, pair) : entries_[place].number;
  }
  /// The number of a pair, or -1.
  int numberOf(const RegionPair& pair) const {
    const Entry& entry = entries_[find(keyOf(pair))];
    return entry.key == 0 ? -1 : entry.number;
  }
  /// Gives a pair that has none a number of the caller's choice.
  void assign(const RegionPair& pair, int number);

  /// The pairs that were added, by number.
  const std::vector<RegionPair>& pairs() const { return pairs_; }

 private:
  struct Entry {
    std::uint64_t key = 0;  // 0: free
    std::int32_t number = 0;
  };

  static std::uint64_t keyOf(const RegionPair& pair) {
    return static_cast<std::uint64_t>(pair.high) << 32 | static_cast<std::uint64_t>(pair.low);
  }
  /// Where the key is, or the free place for it.
  std::size_t find(std::uint64_t key) const {
    constexpr std::uint64_t kGolden = 0x9E3779B97F4A7C15;  // spreads neighbouring labels over the table
    std::size_t place = key * kGolden >> shift_;
    while (entries_[place].key != 0 && entries_[place].key != key) place = (place + 1) & (entries_.size() - 1);
    return place;
  }
  int insert(std::size_t place, const RegionPair& pair);
  void fill(std::size_t place, const Entry& entry);
  void resize(int bits);

  std::vector<Entry> entries_;  // a power of two
  int shift_ = 0;               // of a product to a place
  std::vector<Entry> filled_;   // those that are not free, in the order of their coming
  std::vector<RegionPair> pairs_;
};

}  // namespace epcc
