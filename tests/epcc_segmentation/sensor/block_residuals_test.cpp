// SPDX-License-Identifier: BSD-3-Clause
// Planes of image blocks: what is found, where nothing is, and the same bits on every vector unit.
#include "sensor/block_residuals.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "epcc_segmentation/vector_unit.h"
#include "sensor/image_blocks.h"

namespace epcc {
namespace {

constexpr int kColumnsOfBlocks = 77;  // no multiple of anything
constexpr int kRowsOfBlocks = 45;

/// A wall at about 2 m with a white error of inverse depth.
InverseDepthImage wall(float deviation) {
  InverseDepthImage image;
  image.width = kColumnsOfBlocks;
  image.height = kRowsOfBlocks;
  for (int i = 0; i < kColumnsOfBlocks; ++i) image.across.push_back(0.002 * i);
  for (int i = 0; i < kRowsOfBlocks; ++i) image.along.push_back(0.002 * i);
  image.forward.assign(kColumnsOfBlocks, 1.0);
  image.measured_scale.assign(kRowsOfBlocks, 1.0);
  std::mt19937 generator(4);
  std::normal_distribution<float> normal;
  for (int row = 0; row < kRowsOfBlocks; ++row)
    for (int column = 0; column < kColumnsOfBlocks; ++column)
      image.w.push_back(0.5f + 1e-4f * static_cast<float>(column) - 5e-5f * static_cast<float>(row) +
                        deviation * normal(generator));
  image.w.shrink_to_fit();  // so that reading beyond it is seen
  return image;
}

TEST(BlockResiduals, TellTheErrorAtTheImagesCornersForAllSizes) {
  constexpr float kDeviation = 0.001f;
  const auto image = wall(kDeviation);
  for (const int size : {16, 32})
    for (const int row : {0, kRowsOfBlocks - size})
      for (const int column : {0, kColumnsOfBlocks - size}) {
        const auto block = measureBlock(image, {row, column, size});
        ASSERT_TRUE(block) << size << " at " << row << ", " << column;
        EXPECT_NEAR(block->depth, 2.0, 0.05);
        const double expected = static_cast<double>(kDeviation) * block->depth * block->depth;
        EXPECT_NEAR(block->deviationAlong(1.0) / expected, 1.0, 4.0 / size) << size << " at " << row << ", " << column;
        // Six degrees of freedom each of 16, 64, 256 and 1024 pixels.
        const double n = size * size;
        EXPECT_NEAR(block->kept[0], (1.0 - 96.0 / n) / (1.0 - 6.0 / n), 2.0 / size) << size;
        EXPECT_NEAR(block->kept[1], (1.0 - 24.0 / n) / (1.0 - 6.0 / n), 1.5 / size) << size;
      }
}

TEST(BlockResiduals, ACurvedSurfaceIsNoError) {
  const auto flat = wall(0.001f);
  auto curved = flat;
  for (int row = 0; row < kRowsOfBlocks; ++row)
    for (int column = 0; column < kColumnsOfBlocks; ++column) {
      const float x = static_cast<float>(column - 40) / 16.0f, y = static_cast<float>(row - 20) / 16.0f;
      curved.w[curved.index(row, column)] += 0.01f * x * x + 0.005f * x * y - 0.004f * y * y;  // ten times the error
    }
  for (const int size : {16, 32}) {
    const auto of_flat = measureBlock(flat, {4, 24, size}), of_curved = measureBlock(curved, {4, 24, size});
    ASSERT_TRUE(of_flat && of_curved);
    EXPECT_NEAR(of_curved->deviationAlong(1.0) / of_flat->deviationAlong(1.0), 1.0, 0.08) << size;
    for (std::size_t scale = 0; scale < 2; ++scale)
      EXPECT_NEAR(of_curved->kept[scale], of_flat->kept[scale], 0.12) << size;
  }
}

TEST(BlockResiduals, APlaneOfAScanWithUnevenRingsIsAPlane) {
  InverseDepthImage image;
  image.width = image.height = 64;
  image.planar_rows = false;
  for (int i = 0; i < 64; ++i) {
    const double azimuth = 0.012 * i - 0.5, elevation = 0.006 * i + 0.001 * (i % 2);
    image.across.push_back(std::sin(azimuth));
    image.forward.push_back(std::cos(azimuth));
    image.along.push_back(std::tan(elevation));
    image.measured_scale.push_back(std::cos(elevation));
  }
  for (int row = 0; row < 64; ++row)
    for (int column = 0; column < 64; ++column)
      image.w.push_back(static_cast<float>(image.ray(row, column).dot(Eigen::Vector3d(0.12, 0.3, 0.1))));
  for (const int size : {16, 32}) {
    const auto block = measureBlock(image, {64 - size, 64 - size, size});
    ASSERT_TRUE(block) << size;
    EXPECT_LT(block->deviation, 1e-6 * block->depth) << size;  // rounding
  }
}

TEST(BlockResiduals, HolesAndOutliersChangeLittleUntilThereAreTooMany) {
  auto image = wall(0.001f);
  const auto clean = measureBlock(image, {3, 5, 32});
  for (int row = 3; row < 35; ++row)
    for (int column = 5; column < 10; ++column) image.w[image.index(row, column)] = 0.0f;  // 16 %
  const auto holes = measureBlock(image, {3, 5, 32});
  ASSERT_TRUE(clean && holes);
  EXPECT_NEAR(holes->deviation / clean->deviation, 1.0, 0.05);
  auto outliers = image;
  for (int row = 3; row < 35; ++row)
    for (int column = 32; column < 37; ++column) outliers.w[image.index(row, column)] = 0.8f;
  ASSERT_TRUE(measureBlock(outliers, {3, 5, 32}));
  EXPECT_NEAR(measureBlock(outliers, {3, 5, 32})->deviation / clean->deviation, 1.0, 0.05);
  for (int row = 3; row < 35; ++row)
    for (int column = 10; column < 12; ++column) image.w[image.index(row, column)] = 0.0f;  // 22 %
  EXPECT_FALSE(measureBlock(image, {3, 5, 32}));
}

TEST(BlockResiduals, OfASensorThatMissesPixelsEverywhereLessIsAsked) {
  const auto whole = wall(0.001f);
  auto holed = whole;
  std::mt19937 random(2);
  for (float& w : holed.w)
    if (random() % 10 < 3) w = 0.0f;
  for (const int size : {16, 32}) {
    const auto before = measureBlock(whole, {3, 5, size});
    EXPECT_FALSE(measureBlock(holed, {3, 5, size})) << size;
    const auto block = measureBlock(holed, {3, 5, size}, 0.7);
    ASSERT_TRUE(before && block) << size;
    EXPECT_NEAR(block->deviation / before->deviation, 1.0, 4.0 / size) << size;
    EXPECT_NEAR(block->kept[1], before->kept[1], 0.1) << size;
  }
  EXPECT_NEAR(measureBlock(holed, {3, 5, 32}, 0.7)->kept[0], measureBlock(whole, {3, 5, 32})->kept[0], 0.1);
}

TEST(BlockResiduals, TheFullestBlockTellsWhatASensorMisses) {
  auto image = wall(0.001f);
  for (std::size_t i = 0; i < image.w.size(); i += 4) image.w[i] = 0.0f;
  EXPECT_NEAR(ImageBlocks::fullShare(image, 16), 0.75, 0.01);
  for (int row = 0; row < 32; ++row)
    for (int column = 16; column < kColumnsOfBlocks; ++column) image.w[image.index(row, column)] = 0.0f;
  EXPECT_NEAR(ImageBlocks::fullShare(image, 16), 0.75, 0.01) << "holes of the scene are elsewhere";
  image.w.assign(image.w.size(), 0.5f);
  image.w[0] = 0.0f;
  EXPECT_EQ(ImageBlocks::fullShare(image, 16), 1.0);
  image.w.assign(image.w.size(), 0.0f);
  EXPECT_EQ(ImageBlocks::fullShare(image, 16), 0.5);
}

TEST(BlockResiduals, AConstantBlockHasNoErrorAndNoStep) {
  auto image = wall(0.0f);
  image.w.assign(image.w.size(), 0.5f);
  for (const int size : {16, 32}) {
    const auto block = measureBlock(image, {0, 0, size});
    ASSERT_TRUE(block) << size;
    EXPECT_LT(block->deviation, 1e-7) << size;
    EXPECT_EQ(block->step, 0.0) << size;
  }
}

TEST(BlockResiduals, TheStepOfAQuantisedBlockIsFound) {
  auto image = wall(0.002f);
  for (float& value : image.w) value = std::round(value * 1024.0f) / 1024.0f;
  const auto block = measureBlock(image, {0, 0, 32});
  ASSERT_TRUE(block);
  EXPECT_NEAR(block->step, block->depth * block->depth / 1024.0, 1e-9);
}

TEST(BlockResiduals, AreTheSameBitsOnEveryVectorUnit) {
  auto image = wall(0.001f);
  std::mt19937 generator(6);
  for (float& value : image.w)
    if (generator() % 10 == 0) value = generator() % 2 == 0 ? 0.0f : 0.7f;
  const std::string before = vectorUnit();
  for (const int size : {16, 32}) {
    std::vector<BlockResiduals> found;
    for (const std::string& unit : vectorUnits()) {
      ASSERT_TRUE(setVectorUnit(unit));
      const auto block = measureBlock(image, {kRowsOfBlocks - size, kColumnsOfBlocks - size, size});
      ASSERT_TRUE(block) << unit << ", " << size;
      found.push_back(*block);
      EXPECT_EQ(found.front().depth, block->depth) << unit << ", " << size;
      EXPECT_EQ(found.front().deviation, block->deviation) << unit << ", " << size;
      EXPECT_EQ(found.front().slant, block->slant) << unit << ", " << size;
      EXPECT_EQ(found.front().step, block->step) << unit << ", " << size;
      EXPECT_EQ(found.front().kept, block->kept) << unit << ", " << size;
    }
  }
  setVectorUnit(before);
}

}  // namespace
}  // namespace epcc
