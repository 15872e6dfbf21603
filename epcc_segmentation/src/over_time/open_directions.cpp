// SPDX-License-Identifier: BSD-3-Clause
// What planes leave open of a camera's place, whatever its turn is.
#include <cmath>

#include <Eigen/Eigenvalues>

#include "epcc_segmentation/plane_tracker.h"
#include "symmetric_part.h"

namespace epcc {

namespace {

constexpr double kNothing = 1e-9;  // of the largest eigenvalue: rounding

/// The inverse within what is determined.
Eigen::Matrix3d pseudoInverse(const Eigen::Matrix3d& symmetric) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(symmetric);
  Eigen::Vector3d inverse = Eigen::Vector3d::Zero();
  for (int k = 0; k < 3; ++k)
    if (solver.eigenvalues()(k) > kNothing * solver.eigenvalues()(2)) inverse(k) = 1.0 / solver.eigenvalues()(k);
  return solver.eigenvectors() * inverse.asDiagonal() * solver.eigenvectors().transpose();
}

}  // namespace

std::vector<Vector3> openDirections(const Matrix6& pose_information, double sigma) {
  const Eigen::Matrix<double, 6, 6> information(pose_information);
  if (!information.allFinite()) return {Vector3::UnitX(), Vector3::UnitY(), Vector3::UnitZ()};
  const Eigen::Matrix3d across = information.topRightCorner<3, 3>();
  const Eigen::Matrix3d left = information.bottomRightCorner<3, 3>() -
                               across.transpose() * pseudoInverse(information.topLeftCorner<3, 3>()) * across;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(symmetricPart(left));
  std::vector<Vector3> open;
  for (int k = 0; k < 3; ++k)
    if (!(solver.eigenvalues()(k) * sigma * sigma >= 1.0)) open.push_back(Vector3(solver.eigenvectors().col(k)));
  return open;
}

}  // namespace epcc
