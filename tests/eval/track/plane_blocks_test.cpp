// SPDX-License-Identifier: BSD-3-Clause
// Squares of a label image, cut where labels change, and where they are on a plane.
#include "eval/track/plane_blocks.h"

#include <gtest/gtest.h>

#include <random>

namespace epcc::test {
namespace {

TEST(PlaneBlocks, SquaresOfOnePlaneAreWholeOthersAreCutByRow) {
  // Two squares of 2 x 2: one of plane 1, one with plane 2 in a corner.
  const std::vector<PlaneBlock> blocks = planeBlocks({1, 1, 1, 2,  //
                                                      1, 1, 1, 0},
                                                     4, 2, 2, 0, 1);
  ASSERT_EQ(blocks.size(), 4U);
  EXPECT_TRUE(blocks[0].is_whole);
  EXPECT_EQ(blocks[0].bottom, 2);
  for (std::size_t i = 1; i < 4; ++i) EXPECT_FALSE(blocks[i].is_whole);
  EXPECT_EQ(blocks[2].plane, 2);
  EXPECT_EQ(blocks[2].left, 3);
  EXPECT_EQ(blocks[3].top, 1);
  EXPECT_EQ(blocks[3].right, 3);
  const PlaneBlock square = squareAround(blocks[3], 2);
  EXPECT_EQ(square.top, 0);
  EXPECT_EQ(square.left, 2);
  EXPECT_EQ(square.right, 4);
}

TEST(PlaneBlocks, OfAllTurnsAreEachPixelOnce) {
  std::mt19937 random(3);
  const int width = 37, height = 29;
  std::vector<std::int32_t> labels(static_cast<std::size_t>(width * height));
  for (std::size_t i = 0; i < labels.size(); ++i)
    labels[i] = i % static_cast<std::size_t>(width) < 15 ? 4 : static_cast<std::int32_t>(random() % 3);
  std::vector<std::int32_t> drawn(labels.size(), 0);
  for (int turn = 0; turn < 3; ++turn)
    for (const PlaneBlock& block : planeBlocks(labels, width, height, 5, turn, 3))
      for (int row = block.top; row < block.bottom; ++row)
        for (int column = block.left; column < block.right; ++column) {
          std::int32_t& pixel = drawn[static_cast<std::size_t>(row * width + column)];
          EXPECT_EQ(pixel, 0) << "twice";
          pixel = block.plane;
        }
  EXPECT_EQ(drawn, labels);
}

TEST(PlaneBlocks, FootprintsReachToThePixelsEdges) {
  PinholeCamera camera;
  camera.width = 100;
  camera.height = 80;
  camera.fx = camera.fy = 50;
  camera.cx = 49.5;
  camera.cy = 39.5;
  const PlaneBlock left_half = {1, 0, 80, 0, 50, true};
  const auto corners = footprintOf(left_half, camera, {0, 0, -1, 2});
  ASSERT_TRUE(corners);
  EXPECT_TRUE((*corners)[0].isApprox(Eigen::Vector3d(-2, -1.6, 2), 1e-12));
  EXPECT_TRUE((*corners)[2].isApprox(Eigen::Vector3d(0, 1.6, 2), 1e-12));
  EXPECT_FALSE(footprintOf(left_half, camera, {0, -1, 0, 1})) << "a floor up to its horizon";
}

}  // namespace
}  // namespace epcc::test
