// SPDX-License-Identifier: BSD-3-Clause
// A few steps of Gauss-Newton with weights by the planes' own errors.
#include "over_time/pose_alignment.h"

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <cmath>
#include <limits>

#include "over_time/plane_motion.h"
#include "symmetric_part.h"

namespace epcc {

namespace {

constexpr int kAlignmentSteps = 5;
constexpr double kExactPose = 1e-12;               // rad^2, m^2: a pose that is not to be moved has none
constexpr double kFewestSeen = 4.0;                // independent ones, for three parameters
constexpr double kCauchySquare = 2.4 * 2.4 * 3.0;  // where the weight of a plane is a half, in units of 1

using Matrix6d = Eigen::Matrix<double, 6, 6>;
using Vector6d = Eigen::Matrix<double, 6, 1>;

/// R with M = R R^T, of a positive semi-definite M; nothing where rounding has made M negative.
template <int N>
Eigen::Matrix<double, N, N> rootOf(const Eigen::LDLT<Eigen::Matrix<double, N, N>>& m) {
  Eigen::Matrix<double, N, N> root = m.matrixL();
  root *= m.vectorD().cwiseMax(0.0).cwiseSqrt().asDiagonal();
  return m.transpositionsP().transpose() * root;
}

/// A plane in units of what is seen of it: M = unit unit^T, and M e of an error e is unit u.
struct PlaneInUnits {
  Eigen::Matrix3d unit;
  Eigen::Matrix3d into;  ///< u = into (M e), 0 in directions that are not seen
  Eigen::Matrix4d map_error;

  PlaneInUnits(const MapPlane& plane, const SeenPlane& seen, double error_scale)
      : map_error(rootOf(Eigen::LDLT<Eigen::Matrix4d>(plane.covariance))) {
    const Eigen::LDLT<Eigen::Matrix3d> m(seen.rays / error_scale);
    unit = rootOf(m);
    const Eigen::Vector3d d = m.vectorD();
    const double least = std::numeric_limits<double>::epsilon() * d.maxCoeff();
    const Eigen::Vector3d inverse = (d.array() > least).select(d.cwiseMax(least).cwiseSqrt().cwiseInverse(), 0.0);
    into = inverse.asDiagonal() * m.matrixL().solve(m.transpositionsP() * Eigen::Matrix3d::Identity());
    into /= error_scale;
  }
};

/// How far what is seen is off a plane of the map, in units of their joint error, and what the pose changes of it.
struct Residual {
  Eigen::Vector3d error;
  Eigen::Matrix<double, 3, 6> by_motion;
};

/// The joint error is W = (M^-1 + known)^-1 = unit (1 + unit^T known unit)^-1 unit^T with the map's own, `known`:
/// positive semi-definite, however many powers of ten are between the two.
Residual residualFrom(const Eigen::Isometry3d& pose, const MapPlane& of_map, const SeenPlane& seen,
                      const PlaneInUnits& units) {
  const Eigen::Vector4d plane = planeSeenFrom(pose, of_map.coefficients);
  const Eigen::Vector3d theta = -plane.head<3>() / plane(3);
  const Eigen::Matrix<double, 3, 4> by_plane = units.unit.transpose() * inverseByPlane(plane);
  const Eigen::Matrix<double, 3, 4> known = by_plane * pose.matrix().transpose() * units.map_error;
  const Eigen::LLT<Eigen::Matrix3d> joint(Eigen::Matrix3d::Identity() + known * known.transpose());
  return {joint.matrixL().solve(units.into * (seen.rays_w - seen.rays * theta)),
          joint.matrixL().solve(by_plane * planeByMotion(plane))};
}

}  // namespace

AlignedPose alignPose(const std::vector<MapPlane>& planes, const std::vector<SeenPlane>& seen,
                      const UncertainPose& expected, double error_scale) {
  AlignedPose result;
  result.squared_error.assign(planes.size(), -1.0);
  const Eigen::Isometry3d begin(expected.camera_to_map);
  const Matrix6d uncertainty = Matrix6d(expected.covariance) + kExactPose * Matrix6d::Identity();
  const Matrix6d expected_unit = rootOf(Eigen::LDLT<Matrix6d>(uncertainty));
  std::vector<PlaneInUnits> units;
  for (std::size_t k = 0; k < planes.size(); ++k) units.emplace_back(planes[k], seen[k], error_scale);

  // Least squares in units of what is expected: three rows a plane, six that hold the motion back. Their normal
  // equations would lose what is expected in the rounding of planes that are known far better.
  const auto rows = static_cast<Eigen::Index>(3 * planes.size());
  Eigen::Matrix<double, Eigen::Dynamic, 6> equations(rows + 6, 6);
  Eigen::VectorXd right(rows + 6);
  Vector6d motion = Vector6d::Zero();
  Eigen::HouseholderQR<Eigen::Matrix<double, Eigen::Dynamic, 6>> solver;
  for (int step = 0; step < kAlignmentSteps; ++step) {
    const Eigen::Isometry3d pose = moved(begin, expected_unit * motion);
    equations.topRows(rows).setZero();
    right.head(rows).setZero();
    for (std::size_t k = 0; k < planes.size(); ++k) {
      if (seen[k].samples < kFewestSeen) continue;
      const Residual residual = residualFrom(pose, planes[k], seen[k], units[k]);
      result.squared_error[k] = residual.error.squaredNorm();
      const double trust = std::sqrt(1.0 / (1.0 + result.squared_error[k] / kCauchySquare));
      const auto row = static_cast<Eigen::Index>(3 * k);
      equations.middleRows<3>(row) = trust * residual.by_motion;
      right.segment<3>(row) = trust * residual.error;
    }
    result.information = equations.topRows(rows).transpose() * equations.topRows(rows);
    equations.topRows(rows) *= expected_unit;
    equations.bottomRows<6>().setIdentity();
    right.tail<6>() = -motion;
    solver.compute(equations);
    motion += solver.solve(right);
  }
  result.pose.camera_to_map = moved(begin, expected_unit * motion);
  const Matrix6d inverse = solver.matrixQR().topRows<6>().triangularView<Eigen::Upper>().solve(Matrix6d::Identity());
  const Matrix6d root = expected_unit * inverse;
  result.pose.covariance = symmetricPart(root * root.transpose());
  return result;
}

}  // namespace epcc
