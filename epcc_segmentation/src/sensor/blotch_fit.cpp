// SPDX-License-Identifier: BSD-3-Clause
// Expected residuals (I - H) R (I - H) of a Gaussian correlation; all separates into rows and columns.
#include "sensor/blotch_fit.h"

#include <Eigen/Core>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "pi.h"

namespace epcc {

namespace {

constexpr double kLeastTriedLength = 0.7;
constexpr double kLengthStep = 1.05;
constexpr double kMaxLengthOfBlock = 0.25;
// Grain looks like a few percent of blotches; what that little does to the size of a sample would be large.
constexpr double kNoShare = 0.03;

/// How well W and C explain what was measured.
struct Shares {
  double grain = 0.0;
  double blotches = 0.0;
  double loss = std::numeric_limits<double>::infinity();
};

using Kept = Eigen::Matrix<double, kScales, 1>;

Shares sharesOf(const Kept& measured, const Kept& of_grain, const Kept& of_blotches) {
  Shares best;
  const auto consider = [&](double grain, double blotches) {
    if (!(grain >= 0.0) || !(blotches >= 0.0)) return;
    const double loss = (measured - grain * of_grain - blotches * of_blotches).squaredNorm();
    if (loss < best.loss) best = {grain, blotches, loss};
  };
  const double gg = of_grain.squaredNorm(), bb = of_blotches.squaredNorm(), gb = of_grain.dot(of_blotches);
  const double gm = of_grain.dot(measured), bm = of_blotches.dot(measured);
  const double determinant = gg * bb - gb * gb;
  if (determinant > 0.0) consider((gm * bb - bm * gb) / determinant, (bm * gg - gm * gb) / determinant);
  consider(gm / gg, 0.0);
  consider(0.0, bm / bb);
  return best;
}

}  // namespace

Eigen::MatrixXd orthonormalPolynomials(int side) {
  assert(side > 2);
  constexpr int kDegrees = 3;
  const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(side, -1.0, 1.0);
  Eigen::MatrixXd basis(side, kDegrees);
  for (int i = 0; i < kDegrees; ++i) {
    basis.col(i) = x.array().pow(i);
    for (int k = 0; k < i; ++k) basis.col(i) -= basis.col(k).dot(basis.col(i)) * basis.col(k);
    basis.col(i).normalize();
  }
  return basis;
}

Eigen::MatrixXd correlationMatrix(double length, int side) {
  Eigen::MatrixXd correlation = Eigen::MatrixXd::Identity(side, side);
  for (int lag = 1; length > 0.0 && lag < side; ++lag) {
    correlation.diagonal(lag).setConstant(std::exp(-lag * lag / (2.0 * length * length)));
    correlation.diagonal(-lag) = correlation.diagonal(lag);
  }
  return correlation;
}

double keptByQuadric(double length, int side) {
  const Eigen::MatrixXd basis = orthonormalPolynomials(side);
  const Eigen::VectorXd covered = (basis.transpose() * correlationMatrix(length, side) * basis).diagonal();
  double absorbed = 0.0;
  for (int i = 0; i < basis.cols(); ++i)
    for (int j = 0; i + j < basis.cols(); ++j) absorbed += covered(i) * covered(j);
  return 1.0 - absorbed / (side * side);
}

double Blotches::area() const {
  return 1.0 - share + share * 2.0 * kPi * length * length;
}

double Blotches::effectiveLength() const {
  return std::sqrt(area() / (2.0 * kPi));
}

BlotchTable::BlotchTable(int block_size) {
  const auto keptOf = [block_size](double length) {
    std::array<double, kScales> kept{};
    for (int scale = 0; scale < kScales; ++scale)
      kept[static_cast<std::size_t>(scale)] = keptByQuadric(length, block_size >> (kScales - 1 - scale));
    return kept;
  };
  white_ = keptOf(0.0);
  for (double length = kLeastTriedLength; length <= kMaxLengthOfBlock * block_size; length *= kLengthStep)
    entries_.push_back({length, keptOf(length)});
}

Blotches BlotchTable::fit(const std::array<double, kScales - 1>& kept) const {
  Kept measured;
  measured << Eigen::Map<const Eigen::Matrix<double, kScales - 1, 1>>(kept.data()), 1.0;
  const Eigen::Map<const Kept> white(white_.data());
  Shares best;
  double length = 0.0;
  for (const Entry& entry : entries_) {
    const Shares shares = sharesOf(measured, white, Eigen::Map<const Kept>(entry.kept.data()));
    if (shares.loss >= best.loss) continue;
    best = shares;
    length = entry.length;
  }
  Blotches result;
  result.variance = best.grain + best.blotches;
  result.fitted = best.blotches / result.variance;
  result.share = std::max(0.0, (result.fitted - kNoShare) / (1.0 - kNoShare));
  result.length = length;
  return result;
}

const BlotchTable& blotchTable(int block_size) {
  static const BlotchTable of_16(16);
  static const BlotchTable of_32(32);
  assert(block_size == 16 || block_size == 32);
  return block_size == 16 ? of_16 : of_32;
}

}  // namespace epcc
