// SPDX-License-Identifier: BSD-3-Clause
// A few steps of Gauss-Newton with weights by the planes' own errors.
#include "over_time/pose_alignment.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>

#include "over_time/plane_motion.h"
#include "symmetric_part.h"

namespace epcc {

namespace {

constexpr int kAlignmentSteps = 5;
constexpr double kExactPose = 1e-12;               // rad^2, m^2: a pose that is not to be moved has none
constexpr double kFewestSeen = 4.0;                // independent ones, for three parameters
constexpr double kCauchySquare = 2.4 * 2.4 * 3.0;  // where the weight of a plane is a half, in units of 1

using Matrix6d = Eigen::Matrix<double, 6, 6>;

/// (information + uncertainty^-1)^-1, in units of the uncertainty: there it is 1 or less in all directions, whatever
/// rounding has made of an information that differs by many powers of ten between them.
Matrix6d covarianceWith(const Matrix6d& information, const Matrix6d& uncertainty) {
  const Matrix6d unit = uncertainty.llt().matrixL();
  const Eigen::SelfAdjointEigenSolver<Matrix6d> solver(symmetricPart(unit.transpose() * information * unit));
  const Matrix6d root =
      unit * solver.eigenvectors() * (1.0 + solver.eigenvalues().array().max(0.0)).rsqrt().matrix().asDiagonal();
  return symmetricPart(root * root.transpose());
}

}  // namespace

AlignedPose alignPose(const std::vector<MapPlane>& planes, const std::vector<SeenPlane>& seen,
                      const UncertainPose& expected, double error_scale) {
  AlignedPose result;
  const Eigen::Isometry3d begin(expected.camera_to_map);
  const Matrix6d uncertainty = Matrix6d(expected.covariance) + kExactPose * Matrix6d::Identity();
  const Matrix6d prior = uncertainty.inverse();
  Eigen::Matrix<double, 6, 1> motion = Eigen::Matrix<double, 6, 1>::Zero();
  Matrix6d information;
  result.squared_error.assign(planes.size(), -1.0);
  for (int step = 0; step < kAlignmentSteps; ++step) {
    const Eigen::Isometry3d pose = moved(begin, motion);
    information.setZero();
    Eigen::Matrix<double, 6, 1> gradient = -prior * motion;
    for (std::size_t k = 0; k < planes.size(); ++k) {
      if (seen[k].samples < kFewestSeen) continue;
      const Eigen::Vector4d plane = planeSeenFrom(pose, planes[k].coefficients);
      const Eigen::Matrix<double, 3, 4> by_plane = inverseByPlane(plane);
      const Eigen::Matrix<double, 3, 4> by_map = by_plane * pose.matrix().transpose();
      const Eigen::Matrix3d known = by_map * Eigen::Matrix4d(planes[k].covariance) * by_map.transpose();
      const Eigen::Vector3d q = -plane.head<3>() / plane(3);
      const Eigen::Matrix3d rays = seen[k].rays / error_scale;
      const Eigen::Matrix3d joint = (Eigen::Matrix3d::Identity() + rays * known).inverse();
      const Eigen::Matrix3d weight = symmetricPart(joint * rays);
      const Eigen::Vector3d pull = joint * (seen[k].rays_w / error_scale - rays * q);
      // e^T W e with W e = pull and e = known pull + M^-1 (...): the part that is seen of e.
      const Eigen::Vector3d error = weight.fullPivLu().solve(pull);
      const double square = std::max(0.0, error.dot(pull));
      result.squared_error[k] = square;
      const double trust = 1.0 / (1.0 + square / kCauchySquare);
      const Eigen::Matrix<double, 3, 6> j = by_plane * planeByMotion(plane);
      information += trust * j.transpose() * weight * j;
      gradient += trust * j.transpose() * pull;
    }
    motion += (information + prior).ldlt().solve(gradient);
  }
  result.pose.camera_to_map = moved(begin, motion);
  result.information = information;
  result.pose.covariance = covarianceWith(information, uncertainty);
  return result;
}

}  // namespace epcc
