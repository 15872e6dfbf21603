// SPDX-License-Identifier: BSD-3-Clause
// A desk whose planes are known, rendered many times with errors of one size and correlation length.
#pragma once

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "datasets/noise/noise_field.h"
#include "datasets/rendered/scene.h"
#include "epcc_segmentation/depth_frame.h"
#include "epcc_segmentation/plane_segmentation.h"
#include "epcc_segmentation/sensor_model.h"

namespace epcc::test {

/// e^T C^-1 e of the three parameters that a plane has; 3 on average if the covariance is right.
inline double normalisedSquaredError(const Plane& plane, const Eigen::Vector4d& truth) {
  const Eigen::Vector4d error = plane.coefficients - truth;
  const Eigen::Matrix4d covariance = plane.coefficients_covariance;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> solver(covariance);
  double sum = 0.0;
  for (int k = 1; k < 4; ++k) sum += std::pow(solver.eigenvectors().col(k).dot(error), 2) / solver.eigenvalues()(k);
  return sum;
}

/// The planes of a rendered scene, that of label k + 1 at k.
inline std::vector<Eigen::Vector4d> planesOf(const LabelledFrame& frame) {
  std::vector<Eigen::Vector4d> planes;
  for (const auto& plane : frame.camera.extra["planes"]) {
    Eigen::Vector4d truth;
    for (int k = 0; k < 4; ++k) truth(k) = plane["coefficients"][static_cast<std::size_t>(k)];
    planes.push_back(truth / truth.head<3>().norm());
  }
  return planes;
}

struct Mean {
  double sum = 0.0;
  int count = 0;
  void add(double value) {
    sum += value;
    ++count;
  }
  double value() const { return sum / count; }
};

/// A desk scene on a small image with errors of one sensor, drawn anew for each rendering.
class NoisyDesk : public ::testing::TestWithParam<double> {
 protected:
  NoisyDesk() {
    SceneOptions options;
    options.camera = sceneCamera(240, 135);
    exact_ = renderScene("a", 1, options);
    truths_ = planesOf(exact_);
  }

  LabelledFrame noisy(int run) const {
    LabelledFrame frame = exact_;
    SceneRandom random(static_cast<std::uint64_t>(run), 1);
    const double length = GetParam() > 0.4 ? GetParam() : 0.0;
    const Image<float> field = noiseField(frame.depth.width, frame.depth.height, length, random);
    for (std::size_t i = 0; i < field.data.size(); ++i) {
      float& z = frame.depth.data[i];
      if (z > 0.0f) z += static_cast<float>(sensor().sigmaZ(z)) * field.data[i];
    }
    return frame;
  }

  SensorModel sensor() const { return SensorModel::axial(0.001, 0.002, GetParam()); }

  LabelledFrame exact_;
  std::vector<Eigen::Vector4d> truths_;
};

inline DepthFrame view(const LabelledFrame& frame) {
  return DepthFrame::fromDepth(DepthView<float>{frame.depth.data.data(), frame.depth.width, frame.depth.height},
                               frame.camera.camera);
}

/// The plane of a segmentation that has most of a surface, unless it has much of another.
inline const Plane* planeOn(const PlaneSegmentation& result, const LabelledFrame& frame, std::size_t surface) {
  std::vector<long> pixels(result.planes.size() + 1, 0);
  for (std::size_t i = 0; i < result.labels.size(); ++i)
    if (frame.labels.data[i] == surface + 1) ++pixels[static_cast<std::size_t>(result.labels[i])];
  const auto best = std::max_element(pixels.begin() + 1, pixels.end());
  if (best == pixels.end()) return nullptr;
  const Plane& plane = result.planes[static_cast<std::size_t>(best - pixels.begin()) - 1];
  return static_cast<double>(*best) > 0.9 * static_cast<double>(plane.pixel_count) ? &plane : nullptr;
}

}  // namespace epcc::test
