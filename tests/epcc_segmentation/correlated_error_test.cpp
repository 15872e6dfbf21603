// SPDX-License-Identifier: BSD-3-Clause
// What a patch of alike errors is worth, against sums over all pairs of its pixels.
#include "correlated_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace epcc {
namespace {

/// sum_ij q_i q_j R(i - j) / (sum_i q_i^2) along one side, q = 1 or the place from its middle.
double pairSum(int side, double length, bool slope) {
  double sum = 0.0, squares = 0.0;
  const auto q = [&](int i) { return slope ? i - 0.5 * (side - 1) : 1.0; };
  for (int i = 0; i < side; ++i) {
    squares += q(i) * q(i);
    for (int j = 0; j < side; ++j) sum += q(i) * q(j) * std::exp(-0.5 * (i - j) * (i - j) / (length * length));
  }
  return sum / squares;
}

TEST(CorrelatedError, IsWorthWhatAllPairsOfPixelsSay) {
  for (const double length : {1.5, 4.0, 9.0})
    for (const auto& [a, b] : {std::pair<int, int>{200, 120}, {60, 40}, {40, 9}, {25, 25}}) {
      const SamplesPerIndependent samples = samplesPerIndependent({{1.0, length}, {}}, a, b, 1);
      const double offset = pairSum(a, length, false) * pairSum(b, length, false);
      EXPECT_NEAR(samples.offset / offset, 1.0, 0.01) << a << " " << b << " " << length;
      const double long_slope = std::max(1.0, pairSum(a, length, true) * pairSum(b, length, false));
      EXPECT_NEAR(samples.long_slope / long_slope, 1.0, 0.02) << a << " " << b << " " << length;
      if (b < 3.0 * length) continue;  // nearly all of the slope is lost: a difference of nearly equal numbers
      const double short_slope = std::max(1.0, pairSum(a, length, false) * pairSum(b, length, true));
      EXPECT_NEAR(samples.short_slope / short_slope, 1.0, 0.03) << a << " " << b << " " << length;
    }
}

TEST(CorrelatedError, ALineIsWorthWhatAllPairsOfItsSamplesSay) {
  for (const double length : {0.4, 1.5, 4.0, 9.0})
    for (const int samples : {3, 6, 20, 100}) {
      const auto correlation = autocorrelation({{1.0, length}, {}}, 1);
      const LineSamplesPerIndependent worth = lineSamplesPerIndependent(correlation, samples, samples);
      EXPECT_NEAR(worth.offset / pairSum(samples, length, false), 1.0, 1e-3) << samples << " " << length;
      EXPECT_NEAR(worth.slope / pairSum(samples, length, true), 1.0, 0.02) << samples << " " << length;
      EXPECT_NEAR(worth.square / pairSum(samples, length / std::sqrt(2.0), false), 1.0, 1e-3);
    }
  // A sample at every second pixel, and half of the error grain.
  const LineSamplesPerIndependent sparse = lineSamplesPerIndependent(autocorrelation({{0.5, 4.0}, {}}, 2), 50, 50);
  EXPECT_NEAR(sparse.offset, 0.5 + 0.5 * pairSum(50, 2.0, false), 1e-3);
  // Half of the samples taken leave half of the pairs.
  const LineSamplesPerIndependent half = lineSamplesPerIndependent(autocorrelation({{1.0, 4.0}, {}}, 1), 50, 100);
  EXPECT_NEAR(half.offset - 1.0, 0.5 * (pairSum(100, 4.0, false) - 1.0), 1e-3);
}

TEST(CorrelatedError, GrainIsWorthItsNumberOfSamples) {
  for (const ErrorCorrelation& grain :
       {ErrorCorrelation{}, ErrorCorrelation{{0.0, 5.0}, {}}, ErrorCorrelation{{}, {1.0, 0.0}}}) {
    const SamplesPerIndependent samples = samplesPerIndependent(grain, 100.0, 50.0, 2);
    EXPECT_EQ(samples.offset, 1.0);
    EXPECT_EQ(samples.long_slope, 1.0);
    EXPECT_EQ(samples.short_slope, 1.0);
  }
  const SamplesPerIndependent half = samplesPerIndependent({{0.5, 4.0}, {}}, 1e6, 1e6, 1);
  EXPECT_NEAR(half.offset, 0.5 + 0.5 * 2.0 * 3.14159265 * 16.0, 0.01);
}

TEST(CorrelatedError, AGridHasFewerSamplesForAnIndependentOne) {
  EXPECT_NEAR(samplesPerIndependent({{1.0, 6.0}, {}}, 300.0, 200.0, 1).offset,
              9.0 * samplesPerIndependent({{1.0, 6.0}, {}}, 300.0, 200.0, 3).offset, 1e-9);
}

TEST(CorrelatedError, OfAModelIsAllOfItUnlessAPixelIsASample) {
  EXPECT_EQ(ErrorCorrelation::of(SensorModel::axial(0.01, 0.0, 0.4)).blotches.share, 0.0);
  EXPECT_EQ(ErrorCorrelation::of(SensorModel::axial(0.01, 0.0, 3.0)).blotches.share, 1.0);
  EXPECT_EQ(ErrorCorrelation::of(SensorModel::axial(0.01, 0.0, 3.0)).blotches.length, 3.0);
}

}  // namespace
}  // namespace epcc
