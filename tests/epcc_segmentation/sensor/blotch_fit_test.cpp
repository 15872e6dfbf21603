// SPDX-License-Identifier: BSD-3-Clause
// What quadrics absorb of a correlated error, and the way back from what they leave.
#include "sensor/blotch_fit.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

namespace epcc {
namespace {

/// The same by matrices over all pixels: the trace of (I - H) R (I - H).
double bruteForce(double length, int side) {
  const int n = side * side;
  Eigen::MatrixXd r(n, n), a(n, 6);
  for (int i = 0; i < n; ++i) {
    const double x = i % side, y = i / side;
    a.row(i) << 1.0, x, y, x * x, x * y, y * y;
    for (int j = 0; j < n; ++j) {
      const double d2 = std::pow(x - j % side, 2) + std::pow(y - j / side, 2);
      r(i, j) = length > 0.0 ? std::exp(-d2 / (2.0 * length * length)) : (i == j ? 1.0 : 0.0);
    }
  }
  const Eigen::MatrixXd m = Eigen::MatrixXd::Identity(n, n) - a * (a.transpose() * a).inverse() * a.transpose();
  return (m * r * m).trace() / n;
}

TEST(BlotchFit, WhatAQuadricKeepsAgreesWithTheFullCovariance) {
  for (const int side : {4, 8, 16})
    for (const double length : {0.0, 0.7, 2.5, 5.0})
      EXPECT_NEAR(keptByQuadric(length, side), bruteForce(length, side), 1e-8) << length << ", " << side;
  EXPECT_NEAR(keptByQuadric(0.0, 32), 1.0 - 6.0 / 1024.0, 1e-12);
}

/// What blocks of `side` show of a mixture of grain and blotches.
std::array<double, kScales - 1> keptOf(double share, double length, int side) {
  const auto kept = [&](int s) { return (1.0 - share) * keptByQuadric(0.0, s) + share * keptByQuadric(length, s); };
  return {kept(side / 4) / kept(side), kept(side / 2) / kept(side)};
}

TEST(BlotchFit, LengthShareAndSizeAreRecovered) {
  for (const int side : {16, 32})
    for (const double length : {1.0, side / 12.0, side / 6.0})
      for (const double share : {0.6, 1.0}) {
        const Blotches found = blotchTable(side).fit(keptOf(share, length, side));
        const double kept = (1.0 - share) * keptByQuadric(0.0, side) + share * keptByQuadric(length, side);
        EXPECT_NEAR(found.length / length, 1.0, 0.06) << side << ", " << length << ", " << share;
        EXPECT_NEAR(found.share, share, 0.06) << side << ", " << length << ", " << share;
        EXPECT_NEAR(found.variance * kept, 1.0, 0.1) << side << ", " << length << ", " << share;
      }
}

TEST(BlotchFit, GrainIsGrain) {
  for (const int side : {16, 32}) {
    const Blotches found = blotchTable(side).fit(keptOf(0.0, 1.0, side));
    EXPECT_EQ(found.share, 0.0) << side;
    EXPECT_NEAR(found.effectiveLength(), 0.4, 0.002) << side;
    EXPECT_NEAR(found.variance, 1.0 / (1.0 - 6.0 / (side * side)), 1e-3) << side;
  }
}

TEST(BlotchFit, ASampleOfAMixtureCoversPixelsByTheShares) {
  Blotches blotches;
  blotches.length = 3.0;
  blotches.share = 0.25;
  EXPECT_NEAR(blotches.area(), 0.75 + 0.25 * 2.0 * 3.14159265 * 9.0, 1e-6);
  blotches.share = 1.0;
  EXPECT_NEAR(blotches.effectiveLength(), 3.0, 1e-9);
}

}  // namespace
}  // namespace epcc
