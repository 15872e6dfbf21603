// SPDX-License-Identifier: BSD-3-Clause
// The normal of a plane against an eigensolver, flat, thick, thin as a line and in a point.
#include "metric/smallest_eigenvector.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <random>

namespace {

double smallestVariance(const Eigen::Matrix3d& m) {
  const Eigen::Vector3d n = epcc::smallestEigenvector(m);
  EXPECT_NEAR(n.norm(), 1.0, 1e-12);
  return n.dot(m * n);
}

TEST(SmallestEigenvectorOfThree, AgreesWithAnEigensolver) {
  std::mt19937 generator(4);
  std::normal_distribution<double> normal;
  for (const double middle : {1.0, 0.3, 1e-3, 1e-6, 1e-9})
    for (const double smallest : {0.0, 1e-12, 1e-6, 0.1, 0.999, 1.0})
      for (const double scale : {1e-8, 1.0, 1e4})
        for (int trial = 0; trial < 20; ++trial) {
          const Eigen::Quaterniond turn =
              Eigen::Quaterniond(normal(generator), normal(generator), normal(generator), normal(generator))
                  .normalized();
          const Eigen::Matrix3d rotation = turn.toRotationMatrix();
          const Eigen::Vector3d values = scale * Eigen::Vector3d(1.0, middle, smallest * middle);
          const Eigen::Matrix3d m = rotation * values.asDiagonal() * rotation.transpose();
          const Eigen::Matrix3d symmetric = 0.5 * (m + m.transpose());
          const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(symmetric);
          // Of two that are alike and tiny beside the third it may be any mixture.
          const double mixture = middle <= 1e-6 ? 2e-3 * values(2) : 0.0;
          ASSERT_NEAR(smallestVariance(symmetric), solver.eigenvalues()(0), 1e-14 * scale + mixture) << middle;
          const Eigen::Vector3d bounded = epcc::smallestEigenvector(symmetric, 0.99 * solver.eigenvalues()(0));
          ASSERT_NEAR(bounded.dot(symmetric * bounded), solver.eigenvalues()(0), 1e-14 * scale + mixture) << middle;
          if (smallest > 0.2 || middle < 1e-4) continue;
          ASSERT_NEAR(std::abs(epcc::smallestEigenvector(symmetric).dot(solver.eigenvectors().col(0))), 1.0, 1e-9);
        }
}

TEST(SmallestEigenvectorOfThree, DegenerateMatricesGiveAUnitVector) {
  EXPECT_NEAR(smallestVariance(Eigen::Matrix3d::Identity()), 1.0, 1e-12);
  EXPECT_NEAR(smallestVariance(Eigen::Matrix3d::Zero()), 0.0, 1e-12);
  EXPECT_NEAR(smallestVariance(Eigen::Vector3d(0.0, 0.0, 2.0).asDiagonal()), 0.0, 1e-12);
  EXPECT_NEAR(smallestVariance(Eigen::Vector3d(3.0, 1.0, 2.0).asDiagonal()), 1.0, 1e-12);
}

}  // namespace
