// SPDX-License-Identifier: BSD-3-Clause
// S5: whether the edge between two regions is convex or concave.
#pragma once

#include <cstdint>
#include <vector>

#include "epcc_segmentation/inverse_depth_parameters.h"
#include "inverse_depth/region_pairs.h"

namespace epcc {

/// On a convex edge the surface is the farther of the two planes (the smaller w), in a concave corner the nearer.
enum class Crease : std::uint8_t { Unknown, Convex, Concave };

/// Counts votes of places beside the borders. Keeps its memory from frame to frame.
class CreaseVotes {
 public:
  void clear() {
    table_.clear();
    votes_.clear();
  }
  void add(std::int32_t a, std::int32_t b, bool convex) {
    const auto number = static_cast<std::size_t>(table_.add({a, b}));
    if (number == votes_.size()) votes_.emplace_back();
    (convex ? votes_[number].convex : votes_[number].concave)++;
  }
  /// For as many pairs as another count has.
  void makeRoomAs(const CreaseVotes& other) {
    table_.makeRoom(other.votes_.size());
    votes_.reserve(other.votes_.size());
  }
  /// The votes of another count.
  CreaseVotes& operator+=(const CreaseVotes& other);
  /// After the last vote.
  void count(const InverseDepthParameters::Refinement& parameters);
  Crease kindOf(std::int32_t a, std::int32_t b) const {
    const int number = table_.numberOf({a, b});
    return number < 0 ? Crease::Unknown : kinds_[static_cast<std::size_t>(number)];
  }

 private:
  struct Votes {
    int convex = 0, concave = 0;
  };
  RegionPairTable table_;
  std::vector<Votes> votes_;   // by the numbers of the table
  std::vector<Crease> kinds_;  // the same
};

}  // namespace epcc
