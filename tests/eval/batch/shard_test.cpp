// SPDX-License-Identifier: BSD-3-Clause
// Shards: what they hold, how they are written.
#include "eval/batch/shard.h"

#include <gtest/gtest.h>

namespace {

using epcc::parseShard;
using epcc::Shard;

TEST(Shard, EveryPositionIsInOne) {
  for (std::size_t count = 1; count <= 9; ++count)
    for (std::size_t position = 0; position < 30; ++position) {
      std::size_t holders = 0;
      for (std::size_t number = 1; number <= count; ++number) holders += Shard{number, count}.holds(position) ? 1 : 0;
      EXPECT_EQ(holders, 1U);
    }
  EXPECT_TRUE((Shard{1, 3}.holds(0)));
  EXPECT_TRUE((Shard{3, 3}.holds(5)));
}

TEST(Shard, TextAndBack) {
  EXPECT_EQ(parseShard("2/7")->text(), "2/7");
  EXPECT_EQ(parseShard("1000000/1000000")->number, 1000000U);
  for (const char* bad : {"", "/", "1/", "/1", "0/1", "2/1", "1/1000001", " 1/2", "1/2 ", "1/2/3", "+1/2", "1e0/2"})
    EXPECT_FALSE(parseShard(bad).has_value()) << bad;
}

}  // namespace
