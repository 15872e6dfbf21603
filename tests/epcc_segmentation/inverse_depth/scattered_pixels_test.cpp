// SPDX-License-Identifier: BSD-3-Clause
#include "inverse_depth/scattered_pixels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <random>

#include "tests/support/rendered_room.h"

using epcc::GridSteps;
using epcc::InverseDepthImage;
using epcc::ScatteredPixels;

namespace {

constexpr int kImageWidth = 640, kImageHeight = 480;

InverseDepthImage imageWith(const std::function<bool(int, int)>& keep, int width = kImageWidth,
                            int height = kImageHeight) {
  auto room = epcc::test::renderRoom(epcc::test::cornerPlanes(), epcc::test::testCamera(width, height));
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column)
      if (!keep(row, column)) room.depth[static_cast<std::size_t>(row * width + column)] = 0.0f;
  InverseDepthImage image;
  image.read(room.frame());
  return image;
}

}  // namespace

TEST(ScatteredPixels, WholeSurfacesAreNotScatteredHoweverSmall) {
  ScatteredPixels scattered;
  EXPECT_FALSE(scattered.find(imageWith([](int, int) { return true; })));
  EXPECT_FALSE(scattered.find(imageWith([](int row, int column) { return row < 100 && column > 500; })));
  EXPECT_FALSE(scattered.find(imageWith([](int, int) { return false; })));
}

TEST(ScatteredPixels, BlocksAreAsSmallAsThePatternAllows) {
  ScatteredPixels scattered;
  ASSERT_TRUE(scattered.find(imageWith([](int row, int) { return row % 6 == 3; })));
  EXPECT_EQ(scattered.blocks().steps, GridSteps(2, 6));
  ASSERT_TRUE(scattered.find(imageWith([](int, int column) { return column % 2 == 1; })));
  EXPECT_EQ(scattered.blocks().steps, GridSteps(2, 2));
  std::mt19937 random(1);
  ASSERT_TRUE(scattered.find(imageWith([&](int, int) { return random() % 10 == 0; })));
  EXPECT_EQ(scattered.blocks().steps, GridSteps(4, 4));
  EXPECT_NEAR(scattered.validShare(), 0.1, 0.01);
}

// Of a large image only some pixels are samples, so that another one of their block costs nothing; of a small one each
// is, and blocks would be a coarser image.
TEST(ScatteredPixels, SamplesOfLargeImagesAreWhatIsThereOfTheirBlocks) {
  std::mt19937 random(1);
  const auto missing = [&random](unsigned percent) {
    return [&random, percent](int, int) { return random() % 100 >= percent; };
  };
  ScatteredPixels scattered;
  ASSERT_TRUE(scattered.find(imageWith(missing(25))));
  EXPECT_EQ(scattered.blocks().steps, GridSteps(2, 2));
  EXPECT_TRUE(scattered.holdsTogether());
  const auto& w = scattered.blocks().w;
  EXPECT_GT(std::count_if(w.begin(), w.end(), [](float value) { return value > 0.0f; }),
            0.99 * static_cast<double>(w.size()));
  EXPECT_FALSE(scattered.find(imageWith(missing(12))));
  EXPECT_FALSE(scattered.find(imageWith(missing(25), 320, 240)));
  ASSERT_TRUE(scattered.find(imageWith(missing(40))));
  EXPECT_FALSE(scattered.holdsTogether());
}

TEST(ScatteredPixels, TheErrorIsMeasuredOnAnImageDownToHalfOfItsNeighbours) {
  std::mt19937 random(1);
  const InverseDepthImage some = imageWith([&](int, int) { return random() % 5 < 3; });
  const InverseDepthImage few = imageWith([&](int, int) { return random() % 4 == 0; });
  ScatteredPixels scattered;
  EXPECT_EQ(&scattered.measuredForm(some), &some);
  EXPECT_EQ(&scattered.measuredForm(few), &scattered.blocks());
}

TEST(ScatteredPixels, RaysOfRegularPatternsAreExact) {
  const InverseDepthImage image = imageWith([](int row, int column) { return row % 2 == 0 && column % 2 == 1; });
  ScatteredPixels scattered;
  ASSERT_TRUE(scattered.find(image));
  const InverseDepthImage& blocks = scattered.blocks();
  ASSERT_EQ(blocks.width, kImageWidth / 2);
  ASSERT_EQ(blocks.height, kImageHeight / 2);
  EXPECT_NEAR(blocks.place_beside, 0.0, 1e-15);
  for (int row = 0; row < blocks.height; row += 7)
    for (int column = 0; column < blocks.width; column += 7) {
      EXPECT_EQ(blocks.w[blocks.index(row, column)], image.w[image.index(2 * row, 2 * column + 1)]);
      EXPECT_NEAR((blocks.ray(row, column) - image.ray(2 * row, 2 * column + 1)).norm(), 0.0, 1e-12);
    }
}

TEST(ScatteredPixels, WhatLiesBesideItsRayAddsToThePlaceVariance) {
  std::mt19937 random(1);
  const InverseDepthImage image = imageWith([&](int, int) { return random() % 4 == 0; });
  ScatteredPixels scattered;
  ASSERT_TRUE(scattered.find(image));
  const double step = scattered.blocks().steps.across;
  EXPECT_GT(scattered.blocks().placeVariance(), image.placeVariance());
  EXPECT_LT(scattered.blocks().placeVariance(), 1.5 * step * step * image.placeVariance());
}
