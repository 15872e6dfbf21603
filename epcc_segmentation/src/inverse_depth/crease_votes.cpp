// SPDX-License-Identifier: BSD-3-Clause
// A kind of crease needs a fewest number of votes and a clear majority.
#include "inverse_depth/crease_votes.h"

namespace epcc {

CreaseVotes& CreaseVotes::operator+=(const CreaseVotes& other) {
  const std::vector<RegionPair>& pairs = other.table_.pairs();
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const auto number = static_cast<std::size_t>(table_.add(pairs[k]));
    if (number == votes_.size()) votes_.emplace_back();
    Votes& votes = votes_[number];
    votes.convex += other.votes_[k].convex;
    votes.concave += other.votes_[k].concave;
  }
  return *this;
}

void CreaseVotes::count(const InverseDepthParameters::Refinement& parameters) {
  kinds_.clear();
  for (const Votes& v : votes_) {
    const int total = v.convex + v.concave;
    Crease kind = Crease::Unknown;
    if (total >= parameters.crease_min_votes) {
      if (v.convex >= parameters.crease_agreement * total)
        kind = Crease::Convex;
      else if (v.concave >= parameters.crease_agreement * total)
        kind = Crease::Concave;
    }
    kinds_.push_back(kind);
  }
}

}  // namespace epcc
