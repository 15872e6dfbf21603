// SPDX-License-Identifier: BSD-3-Clause
// Lines along labelled pixels: which there are, and their parameters.
#include "epcc_segmentation/line_fit.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "epcc_segmentation/plane_extractor.h"
#include "tests/support/rendered_room.h"

namespace epcc {
namespace {

const SensorModel kSensor = SensorModel::axial(0.001, 0.001, 0.4);

/// A wall z = 2 + 0.5 x - 0.3 y seen by a camera of 12 x 10 pixels.
struct Wall {
  PinholeCamera camera{12, 10, 20.0, 24.0, 5.5, 4.5};
  std::vector<float> depth;
  Wall() {
    for (int row = 0; row < camera.height; ++row)
      for (int column = 0; column < camera.width; ++column)
        depth.push_back(static_cast<float>(
            2.0 / (1.0 - 0.5 * (column - camera.cx) / camera.fx + 0.3 * (row - camera.cy) / camera.fy)));
  }
  DepthFrame frame() const { return DepthFrame::fromDepth(depth.data(), camera); }
};

TEST(FitLines, TakesRunsOfOneLabelInColumnsAndRows) {
  Wall wall;
  PlaneSegmentation result;
  result.labels.assign(120, 0);
  for (int row = 2; row < 9; ++row) result.labels[static_cast<std::size_t>(row * 12 + 4)] = row < 6 ? 7 : 3;
  wall.depth[4 * 12 + 4] = 0.0f;  // ends nothing
  const auto labels = result.labels;
  ASSERT_TRUE(fitLines(wall.frame(), kSensor, ScanDirection::Both, result));
  EXPECT_EQ(result.labels, labels);
  ASSERT_EQ(result.segments.size(), 2u);  // no three in a row
  EXPECT_EQ(result.segments[0].label, 7);
  EXPECT_EQ(result.segments[0].first, 2);
  EXPECT_EQ(result.segments[0].last, 5);
  EXPECT_EQ(result.segments[0].samples, 3);
  EXPECT_EQ(result.segments[1].label, 3);
  EXPECT_EQ(result.segments[1].line, 4);
}

TEST(FitLines, OfExactDepthsAreExact) {
  const Wall wall;
  PlaneSegmentation result;
  result.labels.assign(120, 1);
  ASSERT_TRUE(fitLines(wall.frame(), kSensor, ScanDirection::Both, result));
  ASSERT_EQ(result.segments.size(), 22u);
  for (const LineSegment& segment : result.segments) {
    // z = 2 + 0.5 x - 0.3 y, with (x, z) or (y, z) on the line through the axis.
    const bool is_row = segment.scan == ScanDirection::Rows;
    const double across =
        is_row ? (segment.line - wall.camera.cy) / wall.camera.fy : (segment.line - wall.camera.cx) / wall.camera.fx;
    const double slope_across = is_row ? -0.3 : 0.5, slope_along = is_row ? 0.5 : -0.3;
    EXPECT_NEAR(segment.theta(0), 0.5 * (1.0 - slope_across * across) / std::hypot(1.0, across), 1e-6);
    EXPECT_NEAR(segment.theta(1), -0.5 * slope_along, 1e-6);
    EXPECT_NEAR(segment.mean.dot(segment.theta), 1.0, 1e-6);
    EXPECT_NEAR(segment.rho(), 1.0 / segment.theta.norm(), 1e-12);
    EXPECT_NEAR(segment.mean(0) * std::cos(segment.alpha()) + segment.mean(1) * std::sin(segment.alpha()),
                segment.rho(), 1e-6);
  }
}

TEST(FitLines, RefusesLabelsOfAnotherSizeAndNoFrame) {
  const Wall wall;
  PlaneSegmentation result;
  result.labels.assign(119, 1);
  result.segments.resize(3);
  EXPECT_FALSE(fitLines(wall.frame(), kSensor, ScanDirection::Both, result));
  EXPECT_TRUE(result.segments.empty());
  EXPECT_EQ(result.labels.size(), 119u);
  result.labels.clear();
  EXPECT_FALSE(fitLines(DepthFrame::fromDepth(nullptr, {}), kSensor, ScanDirection::Both, result));
}

TEST(FitLines, AngleAndDistanceErrAsTheirDerivativesSay) {
  LineSegment segment;
  segment.theta << 0.4, -0.2;
  segment.theta_covariance << 3e-6, 1e-6, 1e-6, 2e-6;
  const Matrix2 covariance = segment.alphaRhoCovariance();
  Eigen::Matrix2d jacobian;
  for (int k = 0; k < 2; ++k) {
    LineSegment up = segment, down = segment;
    up.theta(k) += 1e-6;
    down.theta(k) -= 1e-6;
    jacobian.col(k) << (up.alpha() - down.alpha()) / 2e-6, (up.rho() - down.rho()) / 2e-6;
  }
  const Eigen::Matrix2d expected = jacobian * Eigen::Matrix2d(segment.theta_covariance) * jacobian.transpose();
  EXPECT_LT((Eigen::Matrix2d(covariance) - expected).norm(), 1e-6 * expected.norm());
}

TEST(FitLines, ExtractedSegmentsHaveThemInBothModes) {
  auto room = test::renderRoom(test::cornerPlanes(), test::testCamera(160, 120));
  test::addNoise(room, kSensor, 3);
  for (Parameters parameters : {Parameters(), Parameters::forPaper()}) {
    parameters.line_segments = true;
    PlaneExtractor extractor(parameters, kSensor);
    PlaneSegmentation result;
    ASSERT_TRUE(extractor.extract(room.frame(), result));
    ASSERT_GT(result.segments.size(), 50u);
    for (const LineSegment& segment : result.segments) {
      EXPECT_NEAR(segment.theta.dot(segment.mean), 1.0, 0.01);
      const Eigen::Matrix2d covariance = segment.theta_covariance;
      EXPECT_GT(Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(covariance).eigenvalues()(0), 0.0);
      // The inverse depth in the middle errs by sigma_w over the root of the samples, about.
      const double z = segment.mean.norm();
      const double error =
          std::sqrt(segment.mean.dot(segment.theta_covariance * segment.mean)) * std::sqrt(segment.samples);
      EXPECT_GT(error, 0.2 * kSensor.sigmaZ(z) / z);
      EXPECT_LT(error, 5.0 * kSensor.sigmaZ(z) / z);
    }
  }
}

}  // namespace
}  // namespace epcc
