// SPDX-License-Identifier: BSD-3-Clause
// Only what no known plane explains is left of an image, and comes in blocks.
#include "inverse_depth/open_blocks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "tests/epcc_segmentation/inverse_depth/region_fixture.h"

namespace epcc {
namespace {

class OpenBlocksTest : public ::testing::Test {
 protected:
  OpenBlocksTest() : image_(test::imageOf(test::renderRoom(test::cornerPlanes(), test::testCamera(63, 47)))) {
    map_.labels.assign(image_.w.size(), 1);
  }
  std::int32_t& labelAt(int row, int column) { return map_.labels[image_.index(row, column)]; }

  InverseDepthImage image_;
  RegionMap map_;
  OpenBlocks blocks_;
};

TEST_F(OpenBlocksTest, AFewSamplesAreNothing) {
  for (int k = 0; k < 15; ++k) labelAt(k % 4, k / 4) = 0;
  const std::vector<float> before = image_.w;
  EXPECT_FALSE(blocks_.hideRest(image_, map_));
  EXPECT_EQ(image_.w, before);
}

TEST_F(OpenBlocksTest, ABlockIsLookedAtWithThoseAroundIt) {
  for (int k = 0; k < 16; ++k) labelAt(24 + k % 4, 40 + k / 4) = 0;
  labelAt(20, 38) = 0;  // in the block beside it
  labelAt(2, 2) = 0;    // far away
  const std::vector<float> before = image_.w;
  ASSERT_TRUE(blocks_.hideRest(image_, map_));
  EXPECT_EQ(std::count_if(image_.w.begin(), image_.w.end(), [](float w) { return w > 0.0f; }), 17);
  EXPECT_EQ(image_.w[image_.index(20, 38)], before[image_.index(20, 38)]);
  blocks_.showAll(image_);
  EXPECT_EQ(image_.w, before);
}

TEST_F(OpenBlocksTest, WhatIsPassedOverIsNotLookedAt) {
  for (int row = 8; row < 24; ++row)
    for (int column = 8; column < 24; ++column) labelAt(row, column) = kPassedOver;
  EXPECT_FALSE(blocks_.hideRest(image_, map_));
  EXPECT_EQ(labelAt(8, 8), 0);
}

}  // namespace
}  // namespace epcc
