// SPDX-License-Identifier: BSD-3-Clause
// What inner functions take for granted is asserted, in builds with assertions.
#include <gtest/gtest.h>

#include <vector>

#include "epcc_segmentation/depth_frame.h"
#include "quantile.h"
#include "sensor/blotch_fit.h"
#include "sensor/depth_bins.h"

namespace {

#ifdef NDEBUG
#define EPCC_EXPECT_ASSERTION(statement, condition) GTEST_SKIP() << "this build has no assertions (NDEBUG)"
#else
#define EPCC_EXPECT_ASSERTION(statement, condition) EXPECT_DEATH(statement, condition)
#endif

TEST(Preconditions, DepthRowIsOfADepthImage) {
  [[maybe_unused]] float row[2];
  const std::vector<float> cloud(12, 1.0f);
  [[maybe_unused]] const auto frame =
      epcc::DepthFrame::fromPoints(cloud.data(), 3, 2, 2, epcc::Projection::Perspective);
  EPCC_EXPECT_ASSERTION(frame.depthRow(0, row), "isPinhole");
}

TEST(Preconditions, QuantileIsOfSomething) {
  [[maybe_unused]] std::vector<double> nothing;
  EPCC_EXPECT_ASSERTION(epcc::quantile(nothing, 0.5), "empty");
}

TEST(Preconditions, WhatIsKeptIsOfSomeBins) {
  EPCC_EXPECT_ASSERTION(epcc::DepthBins().kept(epcc::SigmaShape(), 1.0), "empty");
}

TEST(Preconditions, BlotchesAreSeenInABlockWithAQuadric) {
  EPCC_EXPECT_ASSERTION(epcc::keptByQuadric(2.0, 2), "side > 2");
}

}  // namespace
