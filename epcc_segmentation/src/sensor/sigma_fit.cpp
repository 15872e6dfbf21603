// SPDX-License-Identifier: BSD-3-Clause
// Pinball loss at all places of the grid.
#include "sensor/sigma_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace epcc {

namespace {

constexpr double kPinball = 0.3;
constexpr int kSteps = 32;  // of the grid beside zero
constexpr double kLeast = 1e-4;
constexpr double kMost = 0.03;

using Row = std::array<double, kSteps + 1>;

/// Values of a and of b: zero, then evenly spaced on a logarithmic scale.
struct Grid {
  Row value{}, log_value{};
  std::array<double, 2 * kSteps - 1> squared_ratio{};  // (a / b)^2 of values kSteps - 1, ..., -(kSteps - 1) steps apart

  Grid() {
    const double step = std::log(kMost / kLeast) / (kSteps - 1);
    for (int i = 0; i < kSteps; ++i) {
      value[i + 1] = kLeast * std::pow(kMost / kLeast, i / (kSteps - 1.0));
      log_value[i + 1] = std::log(kLeast) + i * step;
    }
    for (int i = 0; i < 2 * kSteps - 1; ++i) squared_ratio[i] = std::exp(2.0 * (kSteps - 1 - i) * step);
  }
};

const Grid& grid() {
  static const Grid the_grid;
  return the_grid;
}

void addLoss(double error, double weight, double& loss) {
  loss += weight * std::max(kPinball * error, (kPinball - 1.0) * error);
}

/// Adds the target's loss at each a and b. log sqrt(a^2 + b^2 z^4) = log b + log sqrt((a/b)^2 + z^4), and the grid has
/// few different a/b.
void addLosses(const SigmaTarget& target, std::array<Row, kSteps + 1>& loss) {
  const Grid& g = grid();
  const double z2 = target.depth * target.depth;
  const double log_z2 = 2.0 * std::log(target.depth);
  std::array<double, 2 * kSteps - 1> log_part;
  for (std::size_t i = 0; i < log_part.size(); ++i) log_part[i] = 0.5 * std::log(g.squared_ratio[i] + z2 * z2);
  for (std::size_t j = 1; j <= kSteps; ++j)
    addLoss(target.log_sigma - (g.log_value[j] + log_z2), target.weight, loss[0][j]);
  for (std::size_t i = 1; i <= kSteps; ++i) {
    addLoss(target.log_sigma - g.log_value[i], target.weight, loss[i][0]);
    const double* part = log_part.data() + (kSteps - 1 - (i - 1));  // a and b alike are in the middle
    for (std::size_t j = 1; j <= kSteps; ++j)
      addLoss(target.log_sigma - (g.log_value[j] + part[j - 1]), target.weight, loss[i][j]);
  }
}

}  // namespace

SigmaFit fitSigma(const std::vector<SigmaTarget>& targets) {
  std::array<Row, kSteps + 1> loss{};
  for (const SigmaTarget& target : targets) addLosses(target, loss);
  loss[0][0] = std::numeric_limits<double>::infinity();  // no error at all is none of the models
  SigmaFit best;
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i <= kSteps; ++i)
    for (std::size_t j = 0; j <= kSteps; ++j) {
      if (loss[i][j] >= smallest) continue;
      smallest = loss[i][j];
      best = {grid().value[i], grid().value[j]};
    }
  return best;
}

}  // namespace epcc
