// SPDX-License-Identifier: BSD-3-Clause
// What the last frames said of pairs of tracks that touch: one surface, or two.
#pragma once

#include <cstddef>
#include <deque>
#include <map>
#include <utility>
#include <vector>

namespace epcc {

/// Two tracks, the older one first.
using TrackPair = std::pair<int, int>;

class PairVotes {
 public:
  /// The last so many votes of a pair count.
  explicit PairVotes(std::size_t memory) : memory_(memory) {}
  void vote(int a, int b, bool is_one);
  /// Votes for one surface, and all that count.
  struct Count {
    TrackPair pair;
    long for_one, all;
  };
  std::vector<Count> counts() const;
  void forget(const TrackPair& pair) { votes_.erase(pair); }

 private:
  std::size_t memory_;
  std::map<TrackPair, std::deque<bool>> votes_;
};

}  // namespace epcc
