// SPDX-License-Identifier: BSD-3-Clause
// Parts that threads finish in any order are taken one after another, each once.
#include "metric/ordered_turns.h"

#include <gtest/gtest.h>

#include <atomic>
#include <numeric>

#include "epcc_segmentation/on_threads.h"

namespace {

TEST(OrderedTurns, PartsAreTakenInOrderWhateverTheThreadsDo) {
  constexpr int kParts = 200;
  std::vector<int> expected(kParts);
  std::iota(expected.begin(), expected.end(), 0);
  epcc::OrderedTurns turns;
  for (int run = 0; run < 50; ++run) {
    turns.begin(kParts);
    std::vector<int> taken;  // no lock: one thread at a time
    std::atomic<int> next{0};
    epcc::onThreads(4, [&] {
      for (int part = next++; part < kParts; part = next++)
        turns.finish(part, [&](int turn) { taken.push_back(turn); });
    });
    ASSERT_EQ(taken, expected);
    ASSERT_EQ(turns.taken(), kParts);
  }
}

TEST(OrderedTurns, AnUnfinishedPartHoldsTheLaterOnesBack) {
  epcc::OrderedTurns turns;
  turns.begin(3);
  std::vector<int> taken;
  const auto take = [&](int turn) { taken.push_back(turn); };
  turns.finish(2, take);
  turns.finish(1, take);
  EXPECT_TRUE(taken.empty());
  turns.finish(0, take);
  EXPECT_EQ(taken, (std::vector<int>{0, 1, 2}));
}

}  // namespace
