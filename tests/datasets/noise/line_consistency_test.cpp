// SPDX-License-Identifier: BSD-3-Clause
// Over many noisy renderings the line segments' errors are as large as their covariances say, short ones' and long
// ones'.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "epcc_segmentation/line_fit.h"
#include "tests/datasets/noise/noisy_desk.h"

namespace epcc {
namespace {

class LineConsistency : public test::NoisyDesk {
 protected:
  /// theta of the line that a scan line sees of a plane.
  Eigen::Vector2d truth(const LineSegment& segment) const {
    const Eigen::Vector4d& plane = truths_[static_cast<std::size_t>(segment.label) - 1];
    const PinholeCamera& camera = exact_.camera.camera;
    const bool is_row = segment.scan == ScanDirection::Rows;
    const double across = is_row ? (segment.line - camera.cy) / camera.fy : (segment.line - camera.cx) / camera.fx;
    const double forward = ((is_row ? plane(1) : plane(0)) * across + plane(2)) / std::hypot(1.0, across);
    return Eigen::Vector2d(forward, is_row ? plane(0) : plane(1)) / -plane(3);
  }
};

TEST_P(LineConsistency, TheErrorsOfFittedLinesAreAsLargeAsTheCovariancesSay) {
  test::Mean all, of_short;
  for (int run = 0; run < 250; ++run) {
    const LabelledFrame frame = noisy(run);
    PlaneSegmentation result;
    for (const std::uint16_t label : frame.labels.data) result.labels.push_back(label <= truths_.size() ? label : 0);
    ASSERT_TRUE(fitLines(test::view(frame), sensor(), ScanDirection::Both, result));
    for (const LineSegment& segment : result.segments) {
      if (segment.line % 10 != 0) continue;  // neighbours err alike
      const Eigen::Vector2d error = Eigen::Vector2d(segment.theta) - truth(segment);
      const double square = error.dot(Eigen::Matrix2d(segment.theta_covariance).inverse() * error);
      all.add(square);
      if (segment.samples < 20) of_short.add(square);
    }
  }
  EXPECT_NEAR(all.value(), 2.0, 0.2);
  EXPECT_GT(of_short.count, 500);
  EXPECT_NEAR(of_short.value(), 2.0, 0.2);
}

INSTANTIATE_TEST_SUITE_P(Length, LineConsistency, ::testing::Values(0.4, 2.0, 4.0));

}  // namespace
}  // namespace epcc
