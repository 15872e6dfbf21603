// SPDX-License-Identifier: BSD-3-Clause
// Newton's method from below on the characteristic polynomial, then the null space of two rows.
#include "metric/smallest_eigenvector.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

namespace epcc {

namespace {

constexpr int kMaxIterations = 30;
constexpr double kConverged = 1e-15;    // of the largest eigenvalue
constexpr double kIndependent = 1e-14;  // squared area of two rows, in the trace to the fourth

Eigen::Vector3d byFullDecomposition(const Eigen::Matrix3d& m) {
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.compute(m);
  return solver.eigenvectors().col(0);
}

}  // namespace

Eigen::Vector3d smallestEigenvector(const Eigen::Matrix3d& m, double bound) {
  const double a = m(0, 0), b = m(1, 1), c = m(2, 2);
  const double d = m(0, 1), e = m(0, 2), f = m(1, 2);
  // x^3 - trace x^2 + minors x - determinant: it rises and is concave below its smallest root, so that Newton's steps
  // from the bound never pass it.
  const double trace = a + b + c;
  if (!(trace > 0.0)) return byFullDecomposition(m);
  const double minor_a = b * c - f * f;
  const double minor_b = a * c - e * e;
  const double minor_c = a * b - d * d;
  const double minors = minor_a + minor_b + minor_c;
  const double determinant = a * minor_a - d * (d * c - f * e) + e * (d * f - b * e);
  double x = bound;
  for (int i = 0; i < kMaxIterations; ++i) {
    const double value = ((x - trace) * x + minors) * x - determinant;
    const double slope = (3.0 * x - 2.0 * trace) * x + minors;
    if (!(slope > 0.0) || !(value < 0.0)) break;
    const double step = -value / slope;
    x += step;
    if (step <= kConverged * trace) break;
  }
  const Eigen::Vector3d row0(a - x, d, e), row1(d, b - x, f), row2(e, f, c - x);
  const Eigen::Vector3d candidates[] = {row0.cross(row1), row0.cross(row2), row1.cross(row2)};
  const double squares[] = {candidates[0].squaredNorm(), candidates[1].squaredNorm(), candidates[2].squaredNorm()};
  int best = squares[1] > squares[0] ? 1 : 0;
  if (squares[2] > squares[best]) best = 2;
  if (!(squares[best] > kIndependent * trace * trace * trace * trace)) return byFullDecomposition(m);
  return candidates[best] / std::sqrt(squares[best]);
}

}  // namespace epcc
