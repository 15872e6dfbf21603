// SPDX-License-Identifier: BSD-3-Clause
// Over many noisy renderings the planes' errors are as large as their covariances say.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "datasets/noise/noise_field.h"
#include "datasets/rendered/scene.h"
#include "epcc_segmentation/plane_extractor.h"
#include "epcc_segmentation/plane_fit.h"

namespace epcc {
namespace {

/// e^T C^-1 e of the three parameters that a plane has; 3 on average if the covariance is right.
double normalisedSquaredError(const Plane& plane, const Eigen::Vector4d& truth) {
  const Eigen::Vector4d error = plane.coefficients - truth;
  const Eigen::Matrix4d covariance = plane.coefficients_covariance;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> solver(covariance);
  double sum = 0.0;
  for (int k = 1; k < 4; ++k) sum += std::pow(solver.eigenvectors().col(k).dot(error), 2) / solver.eigenvalues()(k);
  return sum;
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
class PlaneConsistency : public ::testing::TestWithParam<double> {
 protected:
  PlaneConsistency() {
    SceneOptions options;
    options.camera = sceneCamera(240, 135);
    exact_ = renderScene("a", 1, options);
    for (const auto& plane : exact_.camera.extra["planes"]) {
      Eigen::Vector4d truth;
      for (int k = 0; k < 4; ++k) truth(k) = plane["coefficients"][static_cast<std::size_t>(k)];
      truths_.push_back(truth / truth.head<3>().norm());
    }
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

DepthFrame view(const LabelledFrame& frame) {
  return DepthFrame::fromDepth(DepthView<float>{frame.depth.data.data(), frame.depth.width, frame.depth.height},
                               frame.camera.camera);
}

TEST_P(PlaneConsistency, TheErrorsOfFittedPlanesAreAsLargeAsTheCovariancesSay) {
  Mean mean;
  for (int run = 0; run < 500; ++run) {
    const LabelledFrame frame = noisy(run);
    for (std::size_t k = 0; k < truths_.size(); ++k) {  // one at a time, for they come back in order of size
      PlaneSegmentation one;
      for (const std::uint16_t label : frame.labels.data) one.labels.push_back(label == k + 1 ? 1 : 0);
      ASSERT_TRUE(fitPlanes(view(frame), sensor(), 1, one));
      mean.add(normalisedSquaredError(one.planes.at(0), truths_[k]));
    }
  }
  EXPECT_NEAR(mean.value(), 3.0, 0.3);
}

/// The plane of a segmentation that has most of a surface, unless it has much of another.
const Plane* planeOn(const PlaneSegmentation& result, const LabelledFrame& frame, std::size_t surface) {
  std::vector<long> pixels(result.planes.size() + 1, 0);
  for (std::size_t i = 0; i < result.labels.size(); ++i)
    if (frame.labels.data[i] == surface + 1) ++pixels[static_cast<std::size_t>(result.labels[i])];
  const auto best = std::max_element(pixels.begin() + 1, pixels.end());
  if (best == pixels.end()) return nullptr;
  const Plane& plane = result.planes[static_cast<std::size_t>(best - pixels.begin()) - 1];
  return static_cast<double>(*best) > 0.9 * static_cast<double>(plane.pixel_count) ? &plane : nullptr;
}

TEST_P(PlaneConsistency, SoAreThoseOfSegmentedFramesWithTheSensorGivenAndMeasured) {
  for (const bool measured : {false, true}) {
    PlaneExtractor extractor(Parameters(), measured ? std::nullopt : std::optional<SensorModel>(sensor()));
    Mean mean;
    for (int run = 0; run < 300; ++run) {
      const LabelledFrame frame = noisy(run);
      PlaneSegmentation result;
      ASSERT_TRUE(extractor.extract(view(frame), result));
      for (std::size_t k = 0; k < truths_.size(); ++k)
        if (const Plane* plane = planeOn(result, frame, k)) mean.add(normalisedSquaredError(*plane, truths_[k]));
    }
    EXPECT_GT(mean.count, 600) << measured;
    EXPECT_NEAR(mean.value(), 3.0, 0.9) << measured;  // borders go to the plane that suits them
  }
}

INSTANTIATE_TEST_SUITE_P(Length, PlaneConsistency, ::testing::Values(0.4, 2.0, 4.0));

}  // namespace
}  // namespace epcc
