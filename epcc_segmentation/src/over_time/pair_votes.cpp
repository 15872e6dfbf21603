// SPDX-License-Identifier: BSD-3-Clause
// One list of votes a pair.
#include "over_time/pair_votes.h"

#include <algorithm>

namespace epcc {

void PairVotes::vote(int a, int b, bool is_one) {
  std::deque<bool>& votes = votes_[{std::min(a, b), std::max(a, b)}];
  votes.push_back(is_one);
  if (votes.size() > memory_) votes.pop_front();
}

std::vector<PairVotes::Count> PairVotes::counts() const {
  std::vector<Count> list;
  for (const auto& [pair, votes] : votes_)
    list.push_back(
        {pair, static_cast<long>(std::count(votes.begin(), votes.end(), true)), static_cast<long>(votes.size())});
  return list;
}

}  // namespace epcc
