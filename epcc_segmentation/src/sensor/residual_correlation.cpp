// SPDX-License-Identifier: BSD-3-Clause
// Plain sums over pairs of pixels, and the expectation (I - H) R (I - H), which separates into rows and columns.
#include "sensor/residual_correlation.h"

#include <Eigen/Cholesky>
#include <cmath>

#include "quantile.h"
#include "sensor/blotch_fit.h"

namespace epcc {

namespace {

constexpr double kMinUsableShare = 0.75;

/// The residuals of a block's inliers after a quadric; 0 elsewhere.
struct QuadricErrors {
  Eigen::MatrixXd e, inlier;

  explicit QuadricErrors(const FittedBlock& block) {
    const int side = block.samples.side;
    e = inlier = Eigen::MatrixXd::Zero(side, side);
    Eigen::Matrix<double, 6, 6> a = Eigen::Matrix<double, 6, 6>::Zero();
    Eigen::Matrix<double, 6, 1> b = Eigen::Matrix<double, 6, 1>::Zero();
    for (int row = 0; row < side; ++row)
      for (int column = 0; column < side; ++column) {
        const float along = block.plane.x * block.rays.x[column] + block.plane.forward * block.rays.forward[column];
        const float error =
            block.samples.w[row * block.samples.pitch + column] - (along + block.plane.y * block.rays.y[row]);
        if (!(std::abs(error) <= block.gate)) continue;
        inlier(row, column) = 1.0;
        e(row, column) = static_cast<double>(error);
        const auto h = quadric(block, row, column);
        a += h * h.transpose();
        b += h * e(row, column);
      }
    const Eigen::Matrix<double, 6, 1> q = a.ldlt().solve(b);
    for (int row = 0; row < side; ++row)
      for (int column = 0; column < side; ++column)
        e(row, column) -= inlier(row, column) * q.dot(quadric(block, row, column));
  }

  static Eigen::Matrix<double, 6, 1> quadric(const FittedBlock& block, int row, int column) {
    const auto x = static_cast<double>(block.rays.x[column]);
    const double middle = 0.5 * static_cast<double>(block.rays.y[0] + block.rays.y[block.samples.side - 1]);
    const double y = static_cast<double>(block.rays.y[row]) - middle;
    Eigen::Matrix<double, 6, 1> h;
    h << 1.0, x, y, x * x, x * y, y * y;
    return h;
  }
};

/// Mean over pairs `lag` apart of a(i) b(i + lag).
double pairMean(const Eigen::VectorXd& a, const Eigen::VectorXd& b, int lag) {
  const auto pairs = a.size() - lag;
  return a.head(pairs).dot(b.tail(pairs)) / static_cast<double>(pairs);
}

}  // namespace

ResidualCorrelation::ResidualCorrelation(int block_size) : side_(block_size) {
  by_lag_.resize(static_cast<std::size_t>(side_ / 2 + 1));
}

void ResidualCorrelation::add(const InverseDepthImage& image) {
  const double full_share = ImageBlocks::fullShare(image, side_);
  for (int i = 0; i < ImageBlocks::placeCount(image, side_); ++i) {
    FittedBlock block;
    if (fitBlock(image, ImageBlocks::place(image, side_, i), block, full_share)) addBlock(block);
  }
}

void ResidualCorrelation::addBlock(const FittedBlock& block) {
  const QuadricErrors errors(block);
  const double inliers = errors.inlier.sum();
  const double variance = errors.e.squaredNorm() / inliers;
  if (!(inliers >= kMinUsableShare * block.samples.valid) || !(variance > 0.0)) return;
  for (int lag = 0; lag <= side_ / 2; ++lag) {
    const int rest = side_ - lag;
    const auto pooled = [&](const Eigen::MatrixXd& f) {
      return f.leftCols(rest).cwiseProduct(f.rightCols(rest)).sum() +
             f.topRows(rest).cwiseProduct(f.bottomRows(rest)).sum();
    };
    const double pairs = pooled(errors.inlier);
    if (pairs > 0.0) by_lag_[static_cast<std::size_t>(lag)].push_back(pooled(errors.e) / pairs / variance);
  }
}

std::vector<double> ResidualCorrelation::measured() const {
  std::vector<double> result;
  for (std::vector<double> values : by_lag_) {
    if (values.empty()) return {};
    result.push_back(quantile(values, 0.5));
  }
  return result;
}

std::vector<double> ResidualCorrelation::expected(double grain, double blotches, double length) const {
  const Eigen::MatrixXd h = orthonormalPolynomials(side_);
  std::vector<double> result;
  for (int lag = 0; lag <= side_ / 2; ++lag) {
    double sum = 0.0;
    for (const bool of_blotches : {false, true}) {
      const Eigen::MatrixXd r = correlationMatrix(of_blotches ? length : 0.0, side_);
      const Eigen::MatrixXd covered = r * h;
      const Eigen::MatrixXd inner = h.transpose() * covered;
      double left = r(0, lag);
      for (int i = 0; i < h.cols(); ++i)
        for (int j = 0; i + j < h.cols(); ++j) {
          const double along = pairMean(h.col(i), covered.col(i), lag) + pairMean(covered.col(i), h.col(i), lag);
          left -= along * pairMean(h.col(j), covered.col(j), 0);
          for (int k = 0; k < h.cols(); ++k)
            for (int l = 0; k + l < h.cols(); ++l)
              left += inner(i, k) * inner(j, l) * pairMean(h.col(i), h.col(k), lag) * pairMean(h.col(j), h.col(l), 0);
        }
      sum += (of_blotches ? blotches : grain) * left;
    }
    result.push_back(sum);
  }
  const double variance = result.front();
  for (double& value : result) value /= variance;
  return result;
}

}  // namespace epcc
