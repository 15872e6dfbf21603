// SPDX-License-Identifier: BSD-3-Clause
// The fit of the sensor model is the best of its grid.
#include "sensor/sigma_fit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace epcc {
namespace {

/// The definition: a logarithm for every target, a and b.
SigmaFit bruteForce(const std::vector<SigmaTarget>& targets) {
  std::vector<double> grid = {0.0};
  for (int i = 0; i < 32; ++i) grid.push_back(1e-4 * std::pow(300.0, i / 31.0));
  SigmaFit best;
  double smallest = std::numeric_limits<double>::infinity();
  for (const double a : grid)
    for (const double b : grid) {
      if (a + b <= 0.0) continue;
      double loss = 0.0;
      for (const SigmaTarget& target : targets) {
        const double z2 = target.depth * target.depth;
        const double e = target.log_sigma - 0.5 * std::log(a * a + b * b * z2 * z2);
        loss += target.weight * (e > 0.0 ? 0.3 * e : -0.7 * e);
      }
      if (loss >= smallest) continue;
      smallest = loss;
      best = {a, b};
    }
  return best;
}

TEST(SigmaFit, IsTheBestOfTheGrid) {
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (int trial = 0; trial < 300; ++trial) {
    std::vector<SigmaTarget> targets(1 + trial % 9);
    const double a = 1e-4 * std::pow(200.0, uniform(generator)), b = 1e-4 * std::pow(200.0, uniform(generator));
    for (SigmaTarget& target : targets) {
      target.depth = 0.4 * std::pow(20.0, uniform(generator));
      const double b_z2 = b * target.depth * target.depth;
      target.log_sigma = std::log(std::hypot(a, b_z2)) + 0.4 * uniform(generator);
      target.weight = 4.0 + 16.0 * uniform(generator);  // no whole numbers: places of the grid would be equally good
    }
    const SigmaFit found = fitSigma(targets);
    const SigmaFit expected = bruteForce(targets);
    EXPECT_DOUBLE_EQ(found.a, expected.a) << trial;
    EXPECT_DOUBLE_EQ(found.b, expected.b) << trial;
  }
}

TEST(SigmaFit, WithoutAFiniteTargetThereIsNone) {
  const SigmaFit fit = fitSigma({{1.0, std::numeric_limits<double>::infinity(), 5.0}});
  EXPECT_EQ(fit.a + fit.b, 0.0);
}

}  // namespace
}  // namespace epcc
