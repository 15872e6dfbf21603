// SPDX-License-Identifier: BSD-3-Clause
// What plane fits absorb of a correlated error, and the way back from what they leave.
#include "sensor/fitted_blotches.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

namespace {

using epcc::fittedBlotches;
using epcc::kLags;

/// The same by matrices over all pixels: trace and pairs of (I - H) R (I - H).
epcc::FittedBlotches bruteForce(double length, int size) {
  const int n = size * size;
  Eigen::MatrixXd r(n, n), x(n, 3);
  for (int i = 0; i < n; ++i) {
    x.row(i) << i % size, i / size, 1.0;
    for (int j = 0; j < n; ++j) {
      const double d2 = std::pow(i % size - j % size, 2) + std::pow(i / size - j / size, 2);
      r(i, j) = std::exp(-d2 / (2.0 * length * length));
    }
  }
  const Eigen::MatrixXd m = Eigen::MatrixXd::Identity(n, n) - x * (x.transpose() * x).inverse() * x.transpose();
  const Eigen::MatrixXd left = m * r * m;
  epcc::FittedBlotches result;
  result.kept = left.trace() / n;
  for (std::size_t k = 0; k < kLags.size(); ++k) {
    double sum = 0.0;
    for (int y = 0; y < size; ++y)
      for (int c = 0; c + kLags[k] < size; ++c) sum += left(y * size + c, y * size + c + kLags[k]);
    result.correlation[k] = sum / (size * (size - kLags[k])) / result.kept;
  }
  return result;
}

TEST(FittedBlotches, AgreesWithTheFullCovariance) {
  for (const double length : {1.0, 2.5, 5.0}) {
    const auto expected = bruteForce(length, 16);
    const auto fast = fittedBlotches(length, 16);
    EXPECT_NEAR(fast.kept, expected.kept, 1e-9) << length;
    for (std::size_t k = 0; k < kLags.size(); ++k)
      EXPECT_NEAR(fast.correlation[k], expected.correlation[k], 1e-9) << length << " lag " << kLags[k];
  }
}

TEST(FittedBlotches, GrainLosesThreeDegreesOfFreedomAndLongBlotchesAlmostAll) {
  EXPECT_NEAR(fittedBlotches(0.05, 16).kept, 1.0 - 3.0 / 256.0, 1e-9);
  EXPECT_LT(fittedBlotches(16.0, 16).kept, 0.05);
}

TEST(FittedBlotches, LengthAndShareAreRecovered) {
  for (const int size : {16, 32}) {
    const double length = size / 6.0;
    auto correlation = fittedBlotches(length, size).correlation;
    for (double& value : correlation) value *= 0.7;
    const auto found = epcc::blotchTable(size).fit(correlation);
    EXPECT_NEAR(found.length / length, 1.0, 0.06) << size;
    EXPECT_NEAR(found.share, 0.7, 0.03) << size;
    EXPECT_NEAR(found.errorOverResidual(), std::sqrt(0.3 + 0.7 / fittedBlotches(length, size).kept), 0.05) << size;
  }
}

TEST(FittedBlotches, WithoutCorrelationNothingIsAddedBack) {
  EXPECT_EQ(epcc::blotchTable(32).fit({0.0, 0.0, 0.0, 0.0}).errorOverResidual(), 1.0);
}

}  // namespace
