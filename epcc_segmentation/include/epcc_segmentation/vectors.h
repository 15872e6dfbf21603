// SPDX-License-Identifier: BSD-3-Clause
// Vectors and matrices with one layout for all compiler flags.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace epcc {

// Eigen aligns its own vectors to what the compiler's flags allow, and a program built with -mavx would see another
// size than the library: these have one layout everywhere.

/// Two numbers in the public structs, in one layout for all compiler flags; converts to and from Eigen::Vector2d.
using Vector2 = Eigen::Matrix<double, 2, 1, Eigen::DontAlign>;
/// Three numbers, a point or a direction; converts to and from Eigen::Vector3d.
using Vector3 = Eigen::Matrix<double, 3, 1, Eigen::DontAlign>;
/// A point in single precision; converts to and from Eigen::Vector3f.
using Vector3f = Eigen::Matrix<float, 3, 1, Eigen::DontAlign>;
/// Four numbers, the coefficients of a plane; converts to and from Eigen::Vector4d.
using Vector4 = Eigen::Matrix<double, 4, 1, Eigen::DontAlign>;
/// The covariance of two numbers; converts to and from Eigen::Matrix2d.
using Matrix2 = Eigen::Matrix<double, 2, 2, Eigen::DontAlign>;
/// A covariance of points, or axes; converts to and from Eigen::Matrix3d.
using Matrix3 = Eigen::Matrix<double, 3, 3, Eigen::DontAlign>;
/// The covariance of a plane's coefficients; converts to and from Eigen::Matrix4d.
using Matrix4 = Eigen::Matrix<double, 4, 4, Eigen::DontAlign>;
/// A turn by ω, rad, and a shift by v, m; converts to and from Eigen::Matrix<double, 6, 1>.
using Vector6 = Eigen::Matrix<double, 6, 1, Eigen::DontAlign>;
/// The covariance of one, or the inverse of that.
using Matrix6 = Eigen::Matrix<double, 6, 6, Eigen::DontAlign>;
/// Turns and shifts.
using Isometry3 = Eigen::Transform<double, 3, Eigen::Isometry, Eigen::DontAlign>;

}  // namespace epcc
