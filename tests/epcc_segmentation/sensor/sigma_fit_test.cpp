// SPDX-License-Identifier: BSD-3-Clause
// The fit of the sensor model: the best of its shapes, in any unit of length.
#include "sensor/sigma_fit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "pi.h"

namespace epcc {
namespace {

std::vector<SigmaTarget> someTargets(unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  std::vector<SigmaTarget> targets(1 + seed % 9);
  const double a = 1e-4 * std::pow(200.0, uniform(generator)), b = 1e-4 * std::pow(200.0, uniform(generator));
  for (SigmaTarget& target : targets) {
    target.depth = 0.4 * std::pow(20.0, uniform(generator));
    const double b_z2 = b * target.depth * target.depth;
    target.log_sigma = std::log(std::hypot(a, b_z2)) + 0.4 * uniform(generator);
    target.weight = 4.0 + 16.0 * uniform(generator);
  }
  return targets;
}

double loss(const std::vector<SigmaTarget>& targets, double a, double b) {
  double depth = 0.0, total = 0.0, sum = 0.0;
  for (const SigmaTarget& target : targets) {
    depth += target.weight * std::log(target.depth);
    total += target.weight;
    const double e = target.log_sigma - std::log(std::hypot(a, b * target.depth * target.depth));
    sum += target.weight * (e > 0.0 ? 0.4 * e : -0.6 * e);
  }
  const double z0 = std::exp(depth / total);
  return sum + 0.1 * total * std::abs(std::atan2(b * z0 * z0, a) - 0.25 * kPi);
}

TEST(SigmaFit, NoOtherSizeAtAnyOfItsShapesIsBetter) {
  SigmaFitter fitter(16);
  for (unsigned trial = 0; trial < 100; ++trial) {
    const auto targets = someTargets(trial);
    const SigmaFit found = fitter.fit(targets);
    const double least = loss(targets, found.a, found.b);
    double depth = 0.0, total = 0.0;
    for (const SigmaTarget& target : targets) {
      depth += target.weight * std::log(target.depth);
      total += target.weight;
    }
    const double z0 = std::exp(depth / total);
    for (int shape = 0; shape < 13; ++shape)
      for (double size = 1e-5; size < 1e3; size *= 1.02) {
        const double a = size * std::cos(shape * kPi / 24.0), b = size * std::sin(shape * kPi / 24.0) / (z0 * z0);
        EXPECT_GE(loss(targets, a, b), least - 1e-9) << trial;
      }
  }
}

TEST(SigmaFit, InAnotherUnitOfLengthItIsTheSame) {
  SigmaFitter fitter(16);
  for (unsigned trial = 0; trial < 30; ++trial) {
    auto targets = someTargets(trial);
    const SigmaFit metres = fitter.fit(targets);
    for (SigmaTarget& target : targets) {
      target.depth *= 1000.0;
      target.log_sigma += std::log(1000.0);
    }
    const SigmaFit millimetres = fitter.fit(targets);
    EXPECT_NEAR(millimetres.a, metres.a * 1000.0, 1e-9 * millimetres.a) << trial;
    EXPECT_NEAR(millimetres.b, metres.b / 1000.0, 1e-9 * metres.b) << trial;
  }
}

TEST(SigmaFit, FloorAndGrowthAreToldApartIfTheDepthsDo) {
  SigmaFitter fitter(16);
  for (const bool grows : {false, true}) {
    std::vector<SigmaTarget> targets;
    for (const double z : {0.5, 0.8, 1.2, 2.0, 3.0, 5.0})
      targets.push_back({z, std::log(grows ? 0.003 * z * z : 0.01), 10.0});
    const SigmaFit fit = fitter.fit(targets);
    for (const double z : {0.5, 5.0})
      EXPECT_NEAR(std::hypot(fit.a, fit.b * z * z) / (grows ? 0.003 * z * z : 0.01), 1.0, 0.15) << grows << ", " << z;
  }
  const SigmaFit one = fitter.fit({{2.0, std::log(0.01), 5.0}});
  EXPECT_NEAR(one.a, one.b * 4.0, 1e-9) << "one depth tells nothing of the growth";
}

TEST(SigmaFit, WithoutATargetThereIsNone) {
  const SigmaFit fit = SigmaFitter(4).fit({});
  EXPECT_EQ(fit.a + fit.b, 0.0);
}

}  // namespace
}  // namespace epcc
