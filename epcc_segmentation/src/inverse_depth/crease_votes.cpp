// SPDX-License-Identifier: BSD-3-Clause
// A kind of crease needs a fewest number of votes and a clear majority.
#include "inverse_depth/crease_votes.h"

namespace epcc {

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
