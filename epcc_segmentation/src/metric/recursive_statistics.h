// SPDX-License-Identifier: BSD-3-Clause
// Recursive mean and covariance (Eqs. 12, 13) and the line normal (Eq. 15 in a stable form).
#pragma once

#include <Eigen/Core>
#include <cmath>

namespace epcc {

/// Mean and unbiased covariance of a stream of samples.
template <int Dimension>
struct RecursiveStatistics {
  using Vector = Eigen::Matrix<double, Dimension, 1>;
  using Matrix = Eigen::Matrix<double, Dimension, Dimension>;

  int n = 0;
  Vector mean = Vector::Zero();
  Matrix covariance = Matrix::Zero();

  /// Adds a sample. Eq. 12: mu_n = (n-1)/n mu + x/n. Eq. 13 (weight 1) and Eq. 25 (weight w):
  /// Sigma_n = (n-2)/(n-1) Sigma + w/n (x - mu)(x - mu)^T, mu before the update.
  void add(const Vector& x, double weight = 1.0) {
    ++n;
    if (n == 1) {
      mean = x;
      return;
    }
    const Vector difference = x - mean;
    const double inverse_n = 1.0 / n;
    covariance *= (n - 2.0) / (n - 1.0);
    covariance.noalias() += (weight * inverse_n) * difference * difference.transpose();
    mean += inverse_n * difference;
  }
};

/// Unit eigenvector of the smaller eigenvalue of a symmetric 2x2 matrix; (1, 0) for a multiple of the identity.
inline Eigen::Vector2d smallestEigenvector(const Eigen::Matrix2d& m) {
  const double c = m(0, 1);
  const double half_difference = 0.5 * (m(0, 0) - m(1, 1));
  const double h = std::sqrt(half_difference * half_difference + c * c);
  if (h == 0.0) return Eigen::Vector2d::UnitX();
  const Eigen::Vector2d p =
      half_difference >= 0.0 ? Eigen::Vector2d(-c, half_difference + h) : Eigen::Vector2d(h - half_difference, -c);
  return p / std::sqrt(p.squaredNorm());
}

/// Variance along a unit direction; with the smallest eigenvector the smallest eigenvalue, never negative.
template <typename Matrix, typename Vector>
double varianceAlong(const Matrix& covariance, const Vector& direction) {
  const double variance = direction.dot(covariance * direction);
  return variance > 0.0 ? variance : 0.0;
}

}  // namespace epcc
