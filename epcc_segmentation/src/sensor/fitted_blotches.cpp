// SPDX-License-Identifier: BSD-3-Clause
// Residual covariance (I - H) R (I - H); everything separates into rows and columns.
#include "sensor/fitted_blotches.h"

#include <Eigen/Core>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace epcc {

namespace {

constexpr double kMinLength = 1.0;
constexpr double kMaxLengthOfBlock = 1.0 / 3.0;  // beyond, all lengths look alike to the block
constexpr double kLengthStep = 1.1;

/// A basis function of the plane along one axis, orthonormal: the constant or the tilt.
struct Axis {
  Eigen::VectorXd h;
  Eigen::VectorXd covered;  // C h
  double variance;          // h' C h

  Axis(const Eigen::MatrixXd& c, const Eigen::VectorXd& function)
      : h(function.normalized()), covered(c * h), variance(h.dot(covered)) {}

  /// Mean of h(x) h(x + lag) over the pairs in the block.
  double meanProduct(int lag) const { return mean(h, h, lag); }
  /// Mean of h(x) (C h)(x + lag) and of the same with the pair exchanged, summed.
  double meanCovered(int lag) const { return mean(h, covered, lag) + mean(covered, h, lag); }

 private:
  static double mean(const Eigen::VectorXd& a, const Eigen::VectorXd& b, int lag) {
    const auto pairs = a.size() - lag;
    return a.head(pairs).dot(b.tail(pairs)) / static_cast<double>(pairs);
  }
};

/// Mean covariance that the basis function along (x) across takes from pairs `lag` apart in x.
double absorbed(const Axis& x, const Axis& y, int lag) {
  const double rows = y.meanProduct(0);
  // One factor (C h)(y) h(y) stands for both orders of the pair: in y they coincide.
  return y.meanCovered(0) / 2.0 * x.meanCovered(lag) - rows * x.meanProduct(lag) * x.variance * y.variance;
}

}  // namespace

FittedBlotches fittedBlotches(double length, int size) {
  assert(length > 0.0 && size > 1);  // one pixel has no tilt
  const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(size, -0.5, 0.5) * (size - 1);
  const auto correlation = [length](double distance) {
    return std::exp(-distance * distance / (2.0 * length * length));
  };
  Eigen::MatrixXd c(size, size);
  for (int lag = 0; lag < size; ++lag) {
    c.diagonal(lag).setConstant(correlation(lag));
    c.diagonal(-lag).setConstant(correlation(lag));
  }
  const Axis constant(c, Eigen::VectorXd::Ones(size));
  const Axis tilt(c, x);
  const auto left = [&](int lag) {
    return correlation(lag) - absorbed(constant, constant, lag) - absorbed(tilt, constant, lag) -
           absorbed(constant, tilt, lag);
  };
  FittedBlotches result;
  result.kept = left(0);
  for (std::size_t k = 0; k < kLags.size(); ++k)
    result.correlation[k] = kLags[k] < size ? left(kLags[k]) / result.kept : 0.0;
  return result;
}

double Blotches::errorOverResidual() const {
  return std::sqrt(1.0 - share + share / kept);
}

BlotchTable::BlotchTable(int block_size) {
  assert(block_size > 1);
  for (double length = kMinLength; length <= kMaxLengthOfBlock * block_size; length *= kLengthStep)
    entries_.push_back({length, fittedBlotches(length, block_size)});
}

// Lag 1 is left out: resampling to another grid correlates direct neighbours whatever the sensor does.
Blotches BlotchTable::fit(const std::array<double, kLags.size()>& correlation) const {
  Blotches best;
  double smallest = std::numeric_limits<double>::infinity();
  for (const Entry& entry : entries_) {
    const auto& expected = entry.fitted.correlation;
    double product = 0.0;
    double square = 0.0;
    for (std::size_t k = 1; k < kLags.size(); ++k) {
      product += expected[k] * correlation[k];
      square += expected[k] * expected[k];
    }
    const double share = std::clamp(product / square, 0.0, 1.0);
    const double loss = share * (share * square - 2.0 * product);
    if (loss >= smallest) continue;
    smallest = loss;
    best = {entry.length, share, entry.fitted.kept};
  }
  return best;
}

const BlotchTable& blotchTable(int block_size) {
  static const BlotchTable of_16(16);
  static const BlotchTable of_32(32);
  assert(block_size == 16 || block_size == 32);
  return block_size == 16 ? of_16 : of_32;
}

}  // namespace epcc
