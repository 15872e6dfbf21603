// SPDX-License-Identifier: BSD-3-Clause
// Words that are numbers and words that are none.
#include "datasets/support/number_text.h"

#include <gtest/gtest.h>

#include <cmath>

namespace epcc {
namespace {

TEST(NumberText, WholeWordsAreNumbers) {
  EXPECT_EQ(numberFrom("1.5"), 1.5);
  EXPECT_EQ(numberFrom("+1.5"), 1.5);
  EXPECT_EQ(numberFrom("-2e-3"), -2e-3);
  EXPECT_TRUE(std::isnan(numberFrom("nan").value()));
  EXPECT_TRUE(std::isinf(numberFrom("-inf").value()));
}

TEST(NumberText, EverythingElseIsNone) {
  for (const char* word : {"", "+", "-", "+-1", "1.5x", " 1", "1 ", "1,5", "abc", "0x10", "1e999"})
    EXPECT_FALSE(numberFrom(word).has_value()) << word;
}

TEST(NumberText, WholeNumbersAreDigitsAlone) {
  EXPECT_EQ(wholeNumberFrom("0"), 0U);
  EXPECT_EQ(wholeNumberFrom("007"), 7U);
  EXPECT_EQ(wholeNumberFrom("18446744073709551615"), 18446744073709551615U);
  for (const char* word : {"", "-1", "+1", " 1", "1 ", "1.0", "1e3", "18446744073709551616"})
    EXPECT_FALSE(wholeNumberFrom(word).has_value()) << word;
}

}  // namespace
}  // namespace epcc
