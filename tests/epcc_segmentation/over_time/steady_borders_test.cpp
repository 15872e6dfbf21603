// SPDX-License-Identifier: BSD-3-Clause
// Borders of known planes: no strip lasts along the line where two planes cross.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "inverse_depth/boundary_refinement.h"
#include "tests/epcc_segmentation/inverse_depth/region_fixture.h"

namespace epcc {
namespace {

constexpr int kFloor = 1, kBox = 2;
const SensorModel kCoarse = SensorModel::axial(0.03, 0.0, 0.1);  // a row of the floor lies within sigma of the next
constexpr int kBegin = 60, kEnd = 100;                           // columns of the box

/// A floor with noise, and the front of a box that stands on it: where its plane meets the floor beside it, too, one
/// cannot tell of which a pixel is.
class SteadyBorders : public ::testing::Test {
 protected:
  SteadyBorders() {
    const Eigen::Vector4d floor(0.0, -1.0, 0.0, 1.0), box(0.0, 0.0, -1.0, 2.0);
    room_ = test::renderRoom({floor, box}, test::testCamera());
    test::RenderedRoom without = test::renderRoom({floor}, test::testCamera());
    const int width = room_.camera.width;
    for (std::size_t i = 0; i < room_.labels.size(); ++i) {
      const int column = static_cast<int>(i) % width;
      if (column >= kBegin && column < kEnd) continue;
      room_.depth[i] = without.depth[i];
      room_.labels[i] = without.labels[i];
    }
    test::addNoise(room_, kCoarse, 3);
  }

  /// Pixels of the box's label that are none of the box.
  long strays(const RegionMap& map) const {
    long count = 0;
    for (std::size_t i = 0; i < map.labels.size(); ++i) {
      const int column = static_cast<int>(i) % room_.camera.width;
      count += map.labels[i] == kBox && (column < kBegin - 1 || column > kEnd) ? 1 : 0;
    }
    return count;
  }

  RegionMap refinedOften(int known, std::vector<std::int32_t> labels) const {
    const InverseDepthImage image = test::imageOf(room_, kCoarse);
    RegionMap map = test::regionsOf(image, labels, 2);
    map.known = known;
    RefinementMemory memory;
    InverseDepthParameters parameters;
    parameters.expert.refinement.flip_gain = 1.0;  // the tracker's
    for (int frame = 0; frame < 20; ++frame) refineBoundaries(image, parameters, map, memory);
    return map;
  }

  test::RenderedRoom room_;
};

TEST_F(SteadyBorders, WhatIsSureStays) {
  const RegionMap map = refinedOften(2, room_.labels);
  const long box = std::count(room_.labels.begin(), room_.labels.end(), kBox);
  EXPECT_NEAR(static_cast<double>(std::count(map.labels.begin(), map.labels.end(), kBox)), static_cast<double>(box),
              0.02 * static_cast<double>(box));
}

TEST_F(SteadyBorders, AStripOfEarlierFramesGoes) {
  std::vector<std::int32_t> labels = room_.labels;
  const int width = room_.camera.width;
  int foot = 0;  // the last row of the box
  for (int row = 0; row < room_.camera.height; ++row)
    if (labels[static_cast<std::size_t>(row * width + (kBegin + kEnd) / 2)] == kBox) foot = row;
  ASSERT_GT(foot, 0);
  long strip = 0;
  for (int column = kEnd; column < kEnd + 30; ++column) {
    std::int32_t& label = labels[static_cast<std::size_t>(foot * width + column)];
    strip += label == kFloor ? 1 : 0;
    if (label == kFloor) label = kBox;
  }
  ASSERT_GT(strip, 20);
  EXPECT_GT(strays(refinedOften(0, labels)), 15) << "of planes that are new it may stay";
  EXPECT_LT(strays(refinedOften(2, labels)), 3);
}

}  // namespace
}  // namespace epcc
