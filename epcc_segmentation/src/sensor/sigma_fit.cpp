// SPDX-License-Identifier: BSD-3-Clause
// Pinball loss: at a given shape, the best size is a weighted quantile.
#include "sensor/sigma_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "pi.h"

namespace epcc {

namespace {

constexpr double kSigmaQuantile = 0.4;
constexpr int kShapes = 13;          // from the floor alone to the growth alone
constexpr double kPreference = 0.1;  // for the middle of them, a radian and unit of weight

/// The least value that the values of kSigmaQuantile of the weight do not exceed.
double weightedQuantile(std::vector<std::pair<double, double>>& values, double total) {
  std::sort(values.begin(), values.end());
  double weight = 0.0;
  for (const auto& [value, its_weight] : values) {
    weight += its_weight;
    if (weight >= kSigmaQuantile * total) return value;
  }
  return values.back().first;
}

}  // namespace

SigmaFit SigmaFitter::fit(const std::vector<SigmaTarget>& targets) {
  if (targets.empty()) return {};
  double total = 0.0, log_depth = 0.0;
  for (const SigmaTarget& target : targets) {
    total += target.weight;
    log_depth += target.weight * std::log(target.depth);
  }
  const double mean_depth = std::exp(log_depth / total);
  SigmaFit best;
  double smallest = std::numeric_limits<double>::infinity();
  for (int shape = 0; shape < kShapes; ++shape) {
    const double angle = 0.5 * kPi * shape / (kShapes - 1);
    const double floor = std::cos(angle), growth = std::sin(angle);
    ratios_.clear();
    for (const SigmaTarget& target : targets) {
      const double z = target.depth / mean_depth;
      ratios_.push_back({target.log_sigma - std::log(std::hypot(floor, growth * z * z)), target.weight});
    }
    const double log_size = weightedQuantile(ratios_, total);
    double loss = kPreference * total * std::abs(angle - 0.25 * kPi);
    for (const auto& [ratio, weight] : ratios_)
      loss += weight * std::max(kSigmaQuantile * (ratio - log_size), (kSigmaQuantile - 1.0) * (ratio - log_size));
    if (loss >= smallest) continue;
    smallest = loss;
    best = {std::exp(log_size) * floor, std::exp(log_size) * growth / (mean_depth * mean_depth)};
  }
  return best;
}

}  // namespace epcc
