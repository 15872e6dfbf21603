// SPDX-License-Identifier: BSD-3-Clause
// Normal of a plane: the eigenvector of the smallest eigenvalue of a covariance of three dimensions, and of no other.
#pragma once

#include <Eigen/Core>

namespace epcc {

/// Unit eigenvector of the smallest eigenvalue of a symmetric positive semidefinite 3x3 matrix. `bound`: what that
/// eigenvalue is not below, the nearer the faster.
Eigen::Vector3d smallestEigenvector(const Eigen::Matrix3d& m, double bound = 0.0);

}  // namespace epcc
