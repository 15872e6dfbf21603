// SPDX-License-Identifier: BSD-3-Clause
// S4's queue: the contacts whose regions may merge, the cheapest first.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

namespace epcc {

/// A heap that holds each contact once: a new cost moves it. Entries have four children each, side by side: half the
/// levels of a binary heap. Which of two entries is better cannot be predicted: no branches. Keeps its memory.
class MergeQueue {
 public:
  /// Empties it, for contacts of the numbers [0, contacts).
  void clear(std::size_t contacts) {
    entries_.assign(contacts + kChildren, Entry());
    place_of_.assign(contacts, -1);
    count_ = 0;
  }
  bool empty() const { return count_ == 0; }

  /// Adds a contact or changes its cost.
  void set(std::int32_t contact, double cost) {
    const Entry entry = {ordered(cost), contact};
    const std::int32_t place = placeOf(contact);
    settle(entry, place < 0 ? count_++ : static_cast<std::size_t>(place));
  }

  void remove(std::int32_t contact) {
    if (placeOf(contact) >= 0) removeAt(static_cast<std::size_t>(placeOf(contact)));
  }

  /// The contact of the least cost, of the smallest number among equal ones, so that the order is always the same.
  std::int32_t pop() {
    const std::int32_t contact = entries_.front().contact;
    removeAt(0);
    return contact;
  }

 private:
  static constexpr std::size_t kChildren = 4;

  struct Entry {
    std::int64_t cost = std::numeric_limits<std::int64_t>::max();
    std::int32_t contact = std::numeric_limits<std::int32_t>::max();

    bool operator<(const Entry& other) const {
      return (cost < other.cost) | ((cost == other.cost) & (contact < other.contact));
    }
  };

  /// The bits of a number as an integer of the same order.
  static std::int64_t ordered(double cost) {
    std::int64_t bits = 0;
    std::memcpy(&bits, &cost, sizeof(bits));
    return bits ^ static_cast<std::int64_t>(static_cast<std::uint64_t>(bits >> 63) >> 1);
  }

  std::int32_t& placeOf(std::int32_t contact) { return place_of_[static_cast<std::size_t>(contact)]; }
  void put(const Entry& entry, std::size_t place) {
    entries_[place] = entry;
    placeOf(entry.contact) = static_cast<std::int32_t>(place);
  }
  static std::size_t parentOf(std::size_t place) { return (place - 1) / kChildren; }
  std::size_t lesser(std::size_t a, std::size_t b) const {
    return a ^ ((a ^ b) & (std::size_t{0} - static_cast<std::size_t>(entries_[b] < entries_[a])));
  }

  void removeAt(std::size_t place) {
    placeOf(entries_[place].contact) = -1;
    const Entry moved = entries_[--count_];
    entries_[count_] = Entry();
    if (place != count_) settle(moved, place);
  }

  /// Puts an entry at a free place, or where it belongs above or below it. Behind the last entry are empty ones, which
  /// cost more than all: every place has four children.
  void settle(const Entry& entry, std::size_t place) {
    for (; place > 0 && entry < entries_[parentOf(place)]; place = parentOf(place))
      put(entries_[parentOf(place)], place);
    for (std::size_t first = kChildren * place + 1; first < count_; first = kChildren * place + 1) {
      const std::size_t child = lesser(lesser(first, first + 1), lesser(first + 2, first + 3));
      if (!(entries_[child] < entry)) break;
      put(entries_[child], place);
      place = child;
    }
    put(entry, place);
  }

  std::vector<Entry> entries_;
  std::vector<std::int32_t> place_of_;  // per contact, -1 if it is not in the queue
  std::size_t count_ = 0;
};

}  // namespace epcc
