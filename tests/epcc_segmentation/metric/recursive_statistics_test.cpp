// SPDX-License-Identifier: BSD-3-Clause
// Recursions against batch formulas.
#include "metric/recursive_statistics.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <random>
#include <vector>

namespace {

using epcc::RecursiveStatistics;

template <int Dimension>
void compareWithBatch(unsigned seed, double offset) {
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal;
  using Vector = Eigen::Matrix<double, Dimension, 1>;
  using Matrix = Eigen::Matrix<double, Dimension, Dimension>;
  std::vector<Vector> samples;
  RecursiveStatistics<Dimension> recursive;
  for (int n = 1; n <= 200; ++n) {
    Vector x;
    for (int k = 0; k < Dimension; ++k) x(k) = offset + (k + 1) * normal(generator);
    samples.push_back(x);
    recursive.add(x);

    Vector mean = Vector::Zero();
    for (const auto& s : samples) mean += s / n;
    Matrix covariance = Matrix::Zero();
    if (n > 1)
      for (const auto& s : samples) covariance += (s - mean) * (s - mean).transpose() / (n - 1.0);
    ASSERT_EQ(recursive.n, n);
    ASSERT_LT((recursive.mean - mean).norm(), 1e-9);
    ASSERT_LT((recursive.covariance - covariance).norm(), 1e-9);
  }
}

TEST(RecursiveStatistics, MeanAndCovarianceEqualTheBatchFormulas) {
  compareWithBatch<2>(1, 0.0);
  compareWithBatch<3>(2, 0.0);
}

TEST(RecursiveStatistics, AnOffsetOfKilometresCostsNoAccuracy) {
  compareWithBatch<3>(3, 1000.0);
}

TEST(RecursiveStatistics, WeightScalesOnlyTheNewSampleOfTheCovariance) {
  RecursiveStatistics<2> weighted;
  weighted.add({0.0, 0.0});
  weighted.add({2.0, 0.0});
  weighted.add({1.0, 3.0}, 0.5);
  // (n-2)/(n-1) * diag(2, 0) + 0.5/3 * (0, 3)(0, 3)^T
  EXPECT_NEAR(weighted.covariance(0, 0), 1.0, 1e-12);
  EXPECT_NEAR(weighted.covariance(1, 1), 1.5, 1e-12);
  EXPECT_NEAR(weighted.mean.y(), 1.0, 1e-12);
}

TEST(SmallestEigenvector, AgreesWithAnEigensolverEverywhere) {
  for (int i = 0; i <= 360; ++i) {
    const double angle = i * M_PI / 360.0;
    for (const double flatness : {0.0, 1e-6, 0.1, 0.9}) {
      Eigen::Matrix2d rotation;
      rotation << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
      const Eigen::Matrix2d m = rotation * Eigen::Vector2d(1.0, flatness).asDiagonal() * rotation.transpose();
      const Eigen::Vector2d p = epcc::smallestEigenvector(m);
      ASSERT_NEAR(p.norm(), 1.0, 1e-12);
      const double smallest = Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(m).eigenvalues()(0);
      ASSERT_NEAR(epcc::varianceAlong(m, p), smallest, 1e-12) << "angle " << angle << " flatness " << flatness;
    }
  }
}

TEST(SmallestEigenvector, ExactAxesAndTheIdentityGiveAUnitVector) {
  EXPECT_NEAR(std::abs(epcc::smallestEigenvector(Eigen::Vector2d(2.0, 1.0).asDiagonal()).y()), 1.0, 1e-15);
  EXPECT_NEAR(std::abs(epcc::smallestEigenvector(Eigen::Vector2d(1.0, 2.0).asDiagonal()).x()), 1.0, 1e-15);
  EXPECT_NEAR(epcc::smallestEigenvector(Eigen::Matrix2d::Identity()).norm(), 1.0, 1e-15);
  EXPECT_NEAR(epcc::smallestEigenvector(Eigen::Matrix2d::Zero()).norm(), 1.0, 1e-15);
}

}  // namespace
