// SPDX-License-Identifier: BSD-3-Clause
// The pose is among the keys that the camera file keeps as they are.
#include "datasets/files/frame_pose.h"

#include <string>

#include "datasets/support/input_error.h"

namespace epcc {

namespace {

const char kPose[] = "pose";
constexpr double kRotationTolerance = 1e-3;

using Matrix34 = Eigen::Matrix<double, 3, 4>;

/// Three rows of four as twelve in a row.
nlohmann::json inOneRow(const nlohmann::json& pose) {
  if (!pose.is_array() || pose.size() != 3) return pose;
  nlohmann::json flat = nlohmann::json::array();
  for (const nlohmann::json& row : pose)
    if (row.is_array() && row.size() == 4) flat.insert(flat.end(), row.begin(), row.end());
  return flat;
}

Matrix34 poseMatrix(const std::string& file, const nlohmann::json& pose) {
  const nlohmann::json values = inOneRow(pose);
  if (!values.is_array() || values.size() != 12) throw InputError(file, kPose, "is not 12 numbers, 3x4 row-major");
  Matrix34 matrix;
  for (Eigen::Index i = 0; i < 12; ++i) {
    const nlohmann::json& value = values[static_cast<std::size_t>(i)];
    if (!value.is_number()) throw InputError(file, kPose, "holds something that is not a number");
    matrix(i / 4, i % 4) = value.get<double>();
  }
  return matrix;
}

bool isRotation(const Eigen::Matrix3d& matrix) {
  const Eigen::Matrix3d deviation = matrix * matrix.transpose() - Eigen::Matrix3d::Identity();
  return deviation.cwiseAbs().maxCoeff() <= kRotationTolerance && matrix.determinant() > 0.0;
}

}  // namespace

std::optional<Eigen::Isometry3d> framePose(const LabelledFrame& frame) {
  const nlohmann::json& extra = frame.camera.extra;
  const auto found = extra.find(kPose);
  if (found == extra.end() || found->is_null()) return std::nullopt;
  const std::string file = frame.name + ".json";
  const Matrix34 matrix = poseMatrix(file, *found);
  if (!matrix.allFinite()) throw InputError(file, kPose, "holds a number that is not finite");
  if (!isRotation(matrix.leftCols<3>())) throw InputError(file, kPose, "has no rotation in its first three columns");
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = matrix.leftCols<3>();
  pose.translation() = matrix.col(3);
  return pose;
}

void setFramePose(const Eigen::Isometry3d& pose, LabelledFrame& frame) {
  nlohmann::json values = nlohmann::json::array();
  for (Eigen::Index i = 0; i < 12; ++i) values.push_back(pose.matrix()(i / 4, i % 4));
  frame.camera.extra[kPose] = std::move(values);
}

}  // namespace epcc
