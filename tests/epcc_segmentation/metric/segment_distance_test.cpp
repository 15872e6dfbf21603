// SPDX-License-Identifier: BSD-3-Clause
// Distance between segments against dense sampling, and the degenerate cases.
#include "metric/segment_distance.h"

#include <gtest/gtest.h>

#include <random>

namespace {

using Eigen::Vector3d;

TEST(SegmentDistance, CrossingParallelAndPointSegments) {
  EXPECT_NEAR(epcc::squaredSegmentDistance({-1, 0, 0}, {1, 0, 0}, {0, -1, 2}, {0, 1, 2}), 4.0, 1e-12);
  EXPECT_NEAR(epcc::squaredSegmentDistance({0, 0, 0}, {1, 0, 0}, {0, 3, 0}, {1, 3, 0}), 9.0, 1e-12);
  EXPECT_NEAR(epcc::squaredSegmentDistance({0, 0, 0}, {1, 0, 0}, {4, 0, 0}, {6, 0, 0}), 9.0, 1e-12);
  EXPECT_NEAR(epcc::squaredSegmentDistance({0, 0, 0}, {0, 0, 0}, {-1, 1, 0}, {1, 1, 0}), 1.0, 1e-12);
  EXPECT_NEAR(epcc::squaredSegmentDistance({-1, 1, 0}, {1, 1, 0}, {0, 0, 0}, {0, 0, 0}), 1.0, 1e-12);
  EXPECT_NEAR(epcc::squaredSegmentDistance({1, 2, 3}, {1, 2, 3}, {1, 2, 4}, {1, 2, 4}), 1.0, 1e-12);
}

TEST(SegmentDistance, AgreesWithDenseSampling) {
  std::mt19937 generator(9);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const auto random = [&] { return Vector3d(uniform(generator), uniform(generator), uniform(generator)); };
  for (int trial = 0; trial < 200; ++trial) {
    const Vector3d a1 = random(), b1 = random(), a2 = random(), b2 = random();
    double sampled = 1e9;
    for (int i = 0; i <= 100; ++i)
      for (int j = 0; j <= 100; ++j)
        sampled = std::min(sampled, (a1 + 0.01 * i * (b1 - a1) - a2 - 0.01 * j * (b2 - a2)).norm());
    const double distance = std::sqrt(epcc::squaredSegmentDistance(a1, b1, a2, b2));
    ASSERT_LE(distance, sampled + 1e-12);
    ASSERT_GT(distance, sampled - 0.03);
  }
}

}  // namespace
