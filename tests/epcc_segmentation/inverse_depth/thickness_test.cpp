// SPDX-License-Identifier: BSD-3-Clause
// S9: ragged and narrow regions against compact ones.
#include "inverse_depth/thickness.h"

#include <gtest/gtest.h>

#include "tests/epcc_segmentation/inverse_depth/region_fixture.h"

namespace {

using epcc::InverseDepthImage;
using epcc::InverseDepthParameters;
using epcc::RegionMap;
using epcc::SensorModel;
using epcc::test::RenderedRoom;

constexpr int kWallWidth = 160, kWallHeight = 120;
const SensorModel kWallSensor = SensorModel::axial(0.003, 0.0, 1.0);

/// A wall with the error of the sensor.
RenderedRoom wall() {
  auto room =
      epcc::test::renderRoom({Eigen::Vector4d(0.0, 0.0, -1.0, 2.0)}, epcc::test::testCamera(kWallWidth, kWallHeight));
  epcc::test::addNoise(room, kWallSensor, 1);
  return room;
}

/// Whether the region of the pixels for which `inside` holds stays.
template <typename Inside>
bool stays(const RenderedRoom& room, const Inside& inside, double min_confidence = 0.76) {
  const InverseDepthImage image = epcc::test::imageOf(room, kWallSensor);
  std::vector<std::int32_t> labels;
  for (int row = 0; row < kWallHeight; ++row)
    for (int column = 0; column < kWallWidth; ++column) labels.push_back(inside(row, column) ? 1 : 0);
  epcc::ThicknessMemory memory;
  RegionMap map = epcc::test::regionsOf(image, labels, 1);
  InverseDepthParameters parameters;
  parameters.min_confidence = min_confidence;
  epcc::rejectThin(image, parameters, kWallSensor, 1, map, memory);
  const bool left = !map.regions.empty();
  for (std::size_t i = 0; i < labels.size(); ++i) EXPECT_EQ(map.labels[i], left ? labels[i] : 0);
  return left;
}

const auto square = [](int row, int column) { return row >= 40 && row < 60 && column >= 40 && column < 60; };
const auto comb = [](int row, int column) {  // as many pixels, in teeth one pixel wide
  return row >= 40 && row < 60 && column >= 40 && column < 80 && column % 2 == 0;
};

TEST(Thickness, ACompactRegionStaysACombOfItsSizeGoes) {
  EXPECT_TRUE(stays(wall(), square));
  EXPECT_FALSE(stays(wall(), comb));
  EXPECT_TRUE(stays(wall(), comb, 0.0)) << "0 keeps all";
}

TEST(Thickness, TheImagesEdgeIsNoBorder) {
  const auto strip = [](int row, int column) { return row < 3 && column >= 0; };
  const auto inner_strip = [](int row, int column) { return row >= 40 && row < 43 && column >= 0; };
  EXPECT_TRUE(stays(wall(), strip, 0.90));
  EXPECT_FALSE(stays(wall(), inner_strip, 0.90));
}

TEST(Thickness, HolesAreAQuarterOfABorder) {
  RenderedRoom porous = wall();
  for (int row = 40; row < 60; ++row)
    for (int column = 41; column < 80; column += 2)
      porous.depth[static_cast<std::size_t>(row) * kWallWidth + static_cast<std::size_t>(column)] = 0.0f;
  EXPECT_TRUE(stays(porous, comb)) << "the same comb, its gaps are drop-outs";
}

TEST(Thickness, RoughRegionsMustBeThicker) {
  RenderedRoom rough = wall();
  epcc::test::addNoise(rough, SensorModel::axial(0.01, 0.0, 1.0), 2);
  const auto band = [](int row, int column) { return row >= 40 && row < 48 && column >= 20 && column < 80; };
  EXPECT_TRUE(stays(wall(), band));
  EXPECT_FALSE(stays(rough, band));
}

TEST(Thickness, TheLargestIsTheFirst) {
  const InverseDepthImage image = epcc::test::imageOf(wall(), kWallSensor);
  std::vector<std::int32_t> labels;
  for (int row = 0; row < kWallHeight; ++row)
    for (int column = 0; column < kWallWidth; ++column) labels.push_back(column < 40 ? 1 : column < 120 ? 3 : 2);
  epcc::ThicknessMemory memory;
  RegionMap map = epcc::test::regionsOf(image, labels, 3);
  epcc::rejectThin(image, InverseDepthParameters(), kWallSensor, 1, map, memory);
  ASSERT_EQ(map.regions.size(), 3u);
  ASSERT_EQ(map.confidence.size(), 3u);
  EXPECT_GT(map.confidence[0], map.confidence[1]);
  EXPECT_LE(map.confidence[0], 1.0);
  EXPECT_EQ(map.regions[0].n, 80.0 * kWallHeight);
  const std::int32_t expected[] = {0, 2, 3, 1};  // of equal ones the former first goes first
  for (std::size_t i = 0; i < labels.size(); ++i) EXPECT_EQ(map.labels[i], expected[labels[i]]);
}

TEST(Thickness, WhatIsLeftIsNumberedWithoutGaps) {
  const InverseDepthImage image = epcc::test::imageOf(wall(), kWallSensor);
  std::vector<std::int32_t> labels;
  for (int row = 0; row < kWallHeight; ++row)
    for (int column = 0; column < kWallWidth; ++column) labels.push_back(comb(row, column) ? 2 : column < 30 ? 5 : 0);
  epcc::ThicknessMemory memory;
  RegionMap map = epcc::test::regionsOf(image, labels, 7);
  const double n = map.regions[4].n;
  InverseDepthParameters parameters;
  parameters.min_confidence = 0.76;
  epcc::rejectThin(image, parameters, kWallSensor, 1, map, memory);
  ASSERT_EQ(map.regions.size(), 1u);
  EXPECT_EQ(map.regions[0].n, n);
  for (std::size_t i = 0; i < labels.size(); ++i) EXPECT_EQ(map.labels[i], labels[i] == 5 ? 1 : 0);
}

TEST(Thickness, TheGridChangesLittle) {
  const InverseDepthImage image = epcc::test::imageOf(wall(), kWallSensor);
  InverseDepthImage samples;
  samples.sample(image, 2);
  samples.weigh(kWallSensor, image.placeVariance());
  const SensorModel sensor = SensorModel::axial(0.003, 0.0, 4.0);  // blotches far longer than the grid
  for (const double min_confidence : {0.05, 0.12, 0.29, 0.53, 0.76}) {
    InverseDepthParameters parameters;
    parameters.min_confidence = min_confidence;
    std::vector<bool> left;
    for (const int stride : {1, 2}) {
      const InverseDepthImage& grid = stride == 1 ? image : samples;
      std::vector<std::int32_t> labels;
      for (int row = 0; row < grid.height; ++row)
        for (int column = 0; column < grid.width; ++column)
          labels.push_back(square(row * stride, column * stride) ? 1 : 0);
      epcc::ThicknessMemory memory;
      RegionMap map = epcc::test::regionsOf(grid, labels, 1);
      epcc::rejectThin(grid, parameters, sensor.withCorrelationLength(4.0 / stride), stride, map, memory);
      left.push_back(!map.regions.empty());
    }
    EXPECT_EQ(left[0], left[1]) << min_confidence;
  }
}

}  // namespace
