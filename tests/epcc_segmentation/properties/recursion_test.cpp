// SPDX-License-Identifier: BSD-3-Clause
// Recursions and sums of parts against the sums themselves, and streams against whole frames.
#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Eigenvalues>
#include <string>
#include <vector>

#include "inverse_depth/plane_moments.h"
#include "laser/range_line.h"
#include "metric/recursive_statistics.h"
#include "point_moments.h"
#include "tests/epcc_segmentation/properties/random_frames.h"
#include "tests/epcc_segmentation/properties/sound_result.h"
#include "tests/support/streamed_frame.h"

namespace epcc::test {
namespace {

rc::Gen<double> numberUpTo(double largest) {
  return rc::gen::map(rc::gen::inRange(-1000000, 1000001), [largest](int i) { return 1e-6 * i * largest; });
}

/// Samples about a common point, from a speck to a room, maybe all alike.
template <int Dimension>
std::vector<Eigen::Matrix<double, Dimension, 1>> samples(int fewest = 0) {
  using Vector = Eigen::Matrix<double, Dimension, 1>;
  const double spread = *rc::gen::element(0.0, 1e-6, 1e-3, 1.0, 100.0);
  Vector centre;
  for (int k = 0; k < Dimension; ++k) centre(k) = *numberUpTo(100.0);
  std::vector<Vector> result;
  for (int n = *rc::gen::inRange(fewest, 60); n > 0; --n) {
    Vector x = centre;
    for (int k = 0; k < Dimension; ++k) x(k) += *numberUpTo(spread);
    result.push_back(x);
  }
  return result;
}

template <int Dimension>
void compareWithBatch() {
  using Vector = Eigen::Matrix<double, Dimension, 1>;
  using Matrix = Eigen::Matrix<double, Dimension, Dimension>;
  const std::vector<Vector> all = samples<Dimension>(1);
  RecursiveStatistics<Dimension> recursive;
  for (const Vector& x : all) recursive.add(x);
  const auto n = static_cast<double>(all.size());
  Vector mean = Vector::Zero();
  for (const Vector& x : all) mean += x / n;
  Matrix covariance = Matrix::Zero();
  if (n > 1.0)
    for (const Vector& x : all) covariance += (x - mean) * (x - mean).transpose() / (n - 1.0);
  const double size = 1e-13 * (1.0 + mean.norm());  // of a rounded mean
  RC_ASSERT(recursive.n == static_cast<int>(all.size()));
  RC_ASSERT((recursive.mean - mean).norm() < 100.0 * size);
  RC_ASSERT((recursive.covariance - covariance).norm() <
            1e-9 * covariance.norm() + 100.0 * size * (size + std::sqrt(covariance.norm())));
  RC_ASSERT(covarianceProblem(recursive.covariance, "the recursion") == "");
}

RC_GTEST_PROP(Recursion, MeanAndCovarianceOfTwoNumbersAreThoseOfTheBatch, ()) {
  compareWithBatch<2>();
}
RC_GTEST_PROP(Recursion, MeanAndCovarianceOfPointsAreThoseOfTheBatch, ()) {
  compareWithBatch<3>();
}

RC_GTEST_PROP(Recursion, NoVarianceIsNegativeWhateverTheWeights, ()) {
  RecursiveStatistics<3> weighted;
  for (const Eigen::Vector3d& x : samples<3>(1)) weighted.add(x, std::abs(*numberUpTo(1.0)));
  RC_ASSERT(covarianceProblem(weighted.covariance, "the recursion") == "");
  const Eigen::Vector3d direction(*numberUpTo(1.0), *numberUpTo(1.0), *numberUpTo(1.0));
  RC_ASSERT(varianceAlong(weighted.covariance, direction) >= 0.0);
}

RC_GTEST_PROP(Recursion, TheSmallestEigenvectorHasTheSmallestVariance, ()) {
  RecursiveStatistics<2> statistics;
  for (const Eigen::Vector2d& x : samples<2>(2)) statistics.add(x);
  const Eigen::Vector2d p = smallestEigenvector(statistics.covariance);
  RC_ASSERT(std::abs(p.norm() - 1.0) < 1e-12);
  const double largest = statistics.covariance.norm();
  const double least = Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(statistics.covariance).eigenvalues()(0);
  RC_ASSERT(std::abs(varianceAlong(statistics.covariance, p) - std::max(0.0, least)) <= 1e-12 * largest);
}

RC_GTEST_PROP(Recursion, MomentsOfPartsAddUpToThoseOfTheWhole, ()) {
  PlaneMoments whole, sum, part;
  for (const Eigen::Vector3d& x : samples<3>()) {
    const double w = 0.01 + std::abs(*numberUpTo(2.0)), variance = 1e-6 + std::abs(*numberUpTo(0.1));
    whole.add(x, w, variance);
    part.add(x, w, variance);
    if (*rc::gen::inRange(0, 4) != 0) continue;
    sum += part;
    part = PlaneMoments();
  }
  sum += part;
  RC_ASSERT(sum.n == whole.n);
  RC_ASSERT((sum.rays - whole.rays).norm() <= 1e-12 * whole.rays.norm());
  RC_ASSERT((sum.rays_w - whole.rays_w).norm() <= 1e-12 * whole.rays.norm() * (1.0 + whole.w_sum));
  RC_ASSERT(std::abs(sum.w_w - whole.w_w) <= 1e-12 * whole.w_w);
  RC_ASSERT(whole.n == 0.0 || RegionPlane(whole).rss >= 0.0);
}

// About whatever origins the parts have.
RC_GTEST_PROP(Recursion, SumsOfPointsAboutOtherOriginsAddUp, ()) {
  const std::vector<Eigen::Vector3d> points = samples<3>(1);
  PointMoments sum;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  const auto n = static_cast<double>(points.size());
  for (const Eigen::Vector3d& p : points) {
    PointMoments one;
    one.origin = p + Eigen::Vector3d(*numberUpTo(0.1), *numberUpTo(0.1), *numberUpTo(0.1));
    const Eigen::Vector3d from_origin = p - one.origin;
    one.plain.one = one.weighted.one = 1.0;
    one.plain.first = one.weighted.first = from_origin;
    one.plain.second = one.weighted.second = from_origin * from_origin.transpose();
    sum.add(one);
    mean += p / n;
  }
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& p : points) covariance += (p - mean) * (p - mean).transpose() / n;
  const Plane plane = planeOf(sum, points.size(), 1.0);
  const double rounding = 1e-12 * (1.0 + mean.norm());
  RC_ASSERT((plane.centroid - mean).norm() < rounding);
  RC_ASSERT((plane.points_covariance - covariance).norm() < 1e-9 * covariance.norm() + rounding);
  RC_ASSERT(plane.rms >= 0.0 && plane.coefficients(3) >= 0.0);
  RC_ASSERT(std::abs(plane.coefficients.head<3>().norm() - 1.0) < 1e-9);
}

RC_GTEST_PROP(Recursion, SumsOfAScannedLineAddUp, ()) {
  RangeLineSums whole, parts, part;
  std::vector<LaserSample> all;
  for (int beam = *rc::gen::inRange(3, 40); beam > 0; --beam) {
    const double angle = *numberUpTo(M_PI), range = 0.1 + std::abs(*numberUpTo(20.0));
    const LaserSample sample{{std::cos(angle), std::sin(angle)}, range, 1e-3 + std::abs(*numberUpTo(0.1)), beam};
    whole.add(sample);
    part.add(sample);
    if (beam % 5 != 0) continue;
    parts += part;
    part = RangeLineSums();
  }
  parts += part;
  RC_ASSERT(whole.n() == parts.n());
  RangeLine line, of_parts;
  const bool is_line = whole.solve(line), is_line_of_parts = parts.solve(of_parts);
  RC_PRE(is_line && is_line_of_parts && line.covariance.allFinite());
  RC_ASSERT(whole.squaredErrors(line) >= 0.0);
  RC_ASSERT(covarianceProblem(line.covariance, "the line") == "");
  const double condition = line.covariance.norm() * line.covariance.inverse().norm();
  RC_ASSERT((line.q - of_parts.q).norm() <= 1e-12 * condition * (1.0 + line.q.norm()));
}

/// What a check of Google Test says, in words for rapidcheck, which then looks for a smaller case.
template <typename Check>
std::string failuresOf(const Check& check) {
  testing::TestPartResultArray results;
  {
    const testing::ScopedFakeTestPartResultReporter reporter(
        testing::ScopedFakeTestPartResultReporter::INTERCEPT_ONLY_CURRENT_THREAD, &results);
    check();
  }
  std::string text;
  for (int i = 0; i < results.size(); ++i)
    if (results.GetTestPartResult(i).failed()) text += std::string(results.GetTestPartResult(i).message()) + "\n";
  return text;
}

RC_GTEST_PROP(Recursion, AStreamedDepthImageIsThatSegmentedWhole, ()) {
  FrameSpec spec = *anyFrame({FrameKind::Depth});
  spec.masked = false;
  spec.noise = std::max(2, spec.noise);  // without any, covariances are rounding alone
  if (spec.scene == Scene::Wild) spec.scene = Scene::Planes;
  const RandomFrame frame(spec);
  StreamOptions options;
  options.sensor = frame.sensor();
  options.lines_at_once = *rc::gen::inRange(1, 33);
  options.paper.min_segments = *rc::gen::inRange(1, 20);
  const bool rows = *rc::gen::arbitrary<bool>();
  RC_ASSERT(failuresOf([&] { expectTheWholeFrame(frame.frame(), frame.depth.data(), frame.camera, rows, options); }) ==
            "");
}

}  // namespace
}  // namespace epcc::test
