// SPDX-License-Identifier: BSD-3-Clause
// Depth images whose values are not depths, or stand for nothing.
#include <gtest/gtest.h>

#include <limits>
#include <utility>
#include <vector>

#include "tests/support/rendered_room.h"

namespace {

using epcc::DepthFrame;
using epcc::DepthOptions;
using epcc::DepthView;

TEST(DepthOptions, LengthsOfRaysBecomeDepths) {
  const auto room = epcc::test::renderRoom(epcc::test::cornerPlanes(), epcc::test::testCamera());
  std::vector<float> lengths = room.depth;
  const DepthFrame depths = room.frame();
  Eigen::Vector3d p = Eigen::Vector3d::Zero(), q = p;
  for (int row = 0; row < depths.height(); ++row)
    for (int column = 0; column < depths.width(); ++column)
      if (depths.point(row, column, p)) lengths[depths.index(row, column)] = static_cast<float>(p.norm());
  DepthOptions options;
  options.is_distance = true;
  const DepthFrame frame = DepthFrame::fromDepth(lengths.data(), room.camera).readAs(options);
  std::vector<float> depth_row(160);
  for (const DepthFrame& view : {frame, frame.transposed()})
    for (int row = 0; row < view.height(); ++row) {
      view.depthRow(row, depth_row.data());
      for (int column = 0; column < view.width(); ++column) {
        const DepthFrame expected = view.isTransposed() ? depths.transposed() : depths;
        ASSERT_EQ(view.scanPoint(row, column, p), expected.scanPoint(row, column, q));
        EXPECT_LT((p - q).norm(), 1e-5);
        EXPECT_EQ(static_cast<double>(depth_row[static_cast<std::size_t>(column)]), p.z());
      }
    }
}

TEST(DepthOptions, TheLastIntegerIsNoDepth) {
  std::vector<std::uint16_t> values(200, 1500);
  for (std::size_t i = 0; i < values.size(); i += 3) values[i] = 65535;
  values[100] = 65534;
  const DepthFrame frame =
      DepthFrame::fromDepth(DepthView<std::uint16_t>{values.data(), 100, 2}, {100, 2, 80, 80, 50, 1});
  std::vector<float> depth(100);
  Eigen::Vector3d p;
  for (int row = 0; row < 2; ++row) {
    frame.depthRow(row, depth.data());
    for (int column = 0; column < 100; ++column) {
      const bool is_depth = values[static_cast<std::size_t>(100 * row + column)] != 65535;
      EXPECT_EQ(frame.point(row, column, p), is_depth);
      EXPECT_EQ(depth[static_cast<std::size_t>(column)] > 0.0f, is_depth);
    }
  }
}

TEST(DepthOptions, ARangeOfNoDepthIsRefused) {
  const std::vector<float> depth = {1.0f, 2.0f};
  const auto frame = DepthFrame::fromDepth(depth.data(), {2, 1, 80, 80, 1, 0});
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  for (const auto& [low, high] : {std::pair(5.0, 1.0), {1.0, 1.0}, {-1.0, 1.0}, {0.0, kNone}, {kNone, 1.0}}) {
    DepthOptions options;
    options.min_depth = low;
    options.max_depth = high;
    const auto refused = frame.readAs(options);
    EXPECT_TRUE(refused.empty());
    EXPECT_EQ(refused.status(), epcc::Status::InvalidParameters);
    EXPECT_EQ(refused.problem(), "the depths must be 0 <= min_depth < max_depth");
  }
}

TEST(DepthOptions, ValuesAndRanges) {
  const std::vector<std::uint16_t> values = {500, 1000, 1500, 2000, 2047, 2500};
  DepthOptions options;
  options.invalid = 2047;
  options.min_depth = 0.9;
  options.max_depth = 2.1;
  const auto frame =
      DepthFrame::fromDepth(DepthView<std::uint16_t>{values.data(), 6, 1}, {6, 1, 80, 80, 3, 0}).readAs(options);
  std::vector<float> depth(6);
  frame.depthRow(0, depth.data());
  EXPECT_EQ(depth, (std::vector<float>{0.0f, 1.0f, 1.5f, 2.0f, 0.0f, 0.0f}));
}

}  // namespace
