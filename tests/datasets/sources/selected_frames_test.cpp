// SPDX-License-Identifier: BSD-3-Clause
// A selection has the frames asked for under its own name.
#include "datasets/sources/selected_frames.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/support/tiny_frames.h"

namespace epcc::test {
namespace {

TEST(SelectedFrames, HaveTheirOrderAndADataSetOfTheirOwn) {
  const MemorySource rooms("rooms", {tinyFrame("a", 1), tinyFrame("b", 2), tinyFrame("c", 3)});
  const SelectedFrames some(rooms, "some", {2, 0});
  EXPECT_EQ(some.dataset(), "some");
  ASSERT_EQ(some.size(), 2U);
  EXPECT_EQ(some.name(0), "c");
  EXPECT_EQ(some.read(1).depth.data, rooms.read(0).depth.data);
  EXPECT_TRUE(some.files(0).empty());
  EXPECT_THROW(some.read(2), std::out_of_range);
}

}  // namespace
}  // namespace epcc::test
