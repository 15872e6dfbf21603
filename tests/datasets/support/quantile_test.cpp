// SPDX-License-Identifier: BSD-3-Clause
// Ranks, quantiles and medians of short lists.
#include "datasets/support/quantile.h"

#include <gtest/gtest.h>

namespace epcc {
namespace {

TEST(Quantile, RanksCountFromTheSmallest) {
  EXPECT_EQ(valueOfRank(std::vector<int>{5, 1, 3}, 0), 1);
  EXPECT_EQ(valueOfRank(std::vector<int>{5, 1, 3}, 2), 5);
  EXPECT_EQ(valueOfRank(std::vector<int>{5, 1, 3}, 7), 5);
}

TEST(Quantile, SharesAreOfTheStepsBetweenTheValues) {
  const std::vector<float> values = {4.0F, 0.0F, 3.0F, 1.0F, 2.0F};
  EXPECT_EQ(quantile(values, 0.0), 0.0F);
  EXPECT_EQ(quantile(values, 0.49), 1.0F);
  EXPECT_EQ(quantile(values, 0.5), 2.0F);
  EXPECT_EQ(quantile(values, 1.0), 4.0F);
}

TEST(Quantile, MedianIsTheMeanOfTheMiddleTwo) {
  EXPECT_EQ(median({5.0, 1.0, 3.0}), 3.0);
  EXPECT_EQ(median({5.0, 1.0, 4.0, 2.0}), 3.0);
  EXPECT_EQ(median({7.0, 7.0, 1.0, 1.0}), 4.0);
  EXPECT_EQ(median({2.0}), 2.0);
  EXPECT_EQ(median({}), 0.0);
}

}  // namespace
}  // namespace epcc
