// SPDX-License-Identifier: BSD-3-Clause
// Vectors and matrices with one layout for all compiler flags.
#pragma once

#include <Eigen/Core>

namespace epcc {

/// Vectors and matrices of the public structs. Eigen aligns its own to what the compiler's flags allow, and a program
/// built with -mavx would see another size than the library: these have one layout everywhere.
using Vector2 = Eigen::Matrix<double, 2, 1, Eigen::DontAlign>;
using Vector3 = Eigen::Matrix<double, 3, 1, Eigen::DontAlign>;
using Vector3f = Eigen::Matrix<float, 3, 1, Eigen::DontAlign>;
using Vector4 = Eigen::Matrix<double, 4, 1, Eigen::DontAlign>;
using Matrix2 = Eigen::Matrix<double, 2, 2, Eigen::DontAlign>;
using Matrix3 = Eigen::Matrix<double, 3, 3, Eigen::DontAlign>;
using Matrix4 = Eigen::Matrix<double, 4, 4, Eigen::DontAlign>;

}  // namespace epcc
