// SPDX-License-Identifier: BSD-3-Clause
// Residuals from the plane against 1, u, v, u^2, u v, v^2 in the region's own view.
#include "inverse_depth/region_view.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace epcc {

namespace {

/// A region is sampled on a grid wide enough to leave about this many of its pixels: neighbours hardly differ.
constexpr double kSamples = 500.0;

/// Pixels of a scan more than 78 degrees to the side of a region's middle are left out: u grows without bounds there.
constexpr double kMinDepth = 0.2;

/// 1, u, v, u^2, u v, v^2.
using Terms = Eigen::Matrix<double, 6, 1>;
constexpr int kPowerOfU[] = {0, 1, 0, 2, 1, 0};
constexpr int kPowerOfV[] = {0, 0, 1, 0, 1, 2};

}  // namespace

RegionView::RegionView(const PlaneMoments& region, bool turned) {
  // Rays weighted by w: their direction is the middle of the region.
  const Eigen::Vector3d& middle = region.rays_w;
  if (turned) {
    const double length = std::hypot(middle.x(), middle.z());
    sine_ = middle.x() / length;
    cosine_ = middle.z() / length;
  }
  const double depth = sine_ * middle.x() + cosine_ * middle.z();
  u0_ = (cosine_ * middle.x() - sine_ * middle.z()) / depth;
  v0_ = middle.y() / depth;
  const RegionPlane plane(region);
  q_ = plane.q;
  slope_factor_ = plane.slope_factor;
  stride_ = std::max(1, static_cast<int>(std::sqrt(region.n / kSamples)));
  normal_ = {cosine_ * q_.x() - sine_ * q_.z(), q_.y(), sine_ * q_.x() + cosine_ * q_.z()};
}

void RegionView::addRun(const InverseDepthImage& image, int row, int begin, int end) {
  if (!isOnGrid(row)) return;
  const int first = (begin + stride_ - 1) / stride_ * stride_;
  const double along = image.along[static_cast<std::size_t>(row)];
  if (image.planar_rows)
    addPlanarRun(image, row, first, end, along - v0_);
  else
    for (int column = first; column < end; column += stride_) addOfScan(image, row, column, along);
}

RegionView& RegionView::operator+=(const RegionView& other) {
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 5; ++j) products_[i][j] += other.products_[i][j];
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) residuals_[i][j] += other.residuals_[i][j];
  rss_ += other.rss_;
  return *this;
}

Bending RegionView::bending() const {
  Eigen::Matrix<double, 6, 6> normal_matrix;
  Terms right_side;
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 6; ++j)
      normal_matrix(i, j) = products_[kPowerOfU[i] + kPowerOfU[j]][kPowerOfV[i] + kPowerOfV[j]];
    right_side[i] = residuals_[kPowerOfU[i]][kPowerOfV[i]];
  }
  const Terms c = normal_matrix.ldlt().solve(right_side);
  const double scale = stride_ * stride_ / slope_factor_;
  Bending result;
  result.rss = scale * rss_;
  result.gain = std::min(result.rss, scale * c.dot(right_side));
  // The surface is F = z w(x/z, y/z) - 1 = 0 with gradient `normal` and, in the middle, second derivatives
  // J^T H J / z, J = z d(u, v) / d(x, y, z). Its second fundamental form is their restriction to the tangents.
  Eigen::Matrix2d hessian;
  hessian << 2.0 * c[3], c[4], c[4], 2.0 * c[5];
  Eigen::Matrix<double, 2, 3> j;
  j << 1.0, 0.0, -u0_, 0.0, 1.0, -v0_;
  Eigen::Matrix<double, 3, 2> tangents;
  tangents.col(0) = normal_.unitOrthogonal();
  tangents.col(1) = normal_.normalized().cross(tangents.col(0));
  const Eigen::Matrix2d along_tangents = tangents.transpose() * j.transpose() * hessian * j * tangents;
  const double inverse_depth = normal_.dot(Eigen::Vector3d(u0_, v0_, 1.0));
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> principal(along_tangents, Eigen::EigenvaluesOnly);
  result.curvature = principal.eigenvalues().cwiseAbs().maxCoeff() * inverse_depth / normal_.norm();
  return result;
}

void RegionView::addPlanarRun(const InverseDepthImage& image, int row, int first, int end, double v) {
  const std::size_t start = image.index(row, 0);
  const double q_row = q_.y() * image.along[static_cast<std::size_t>(row)] + q_.z();
  Sums sums;
  for (auto column = static_cast<std::size_t>(first); column < static_cast<std::size_t>(end);
       column += static_cast<std::size_t>(stride_)) {
    const double across = image.across[column];
    const double error = static_cast<double>(image.w[start + column]) - (q_.x() * across + q_row);
    sums.add(across - u0_, error, static_cast<double>(image.weight[start + column]));
  }
  add(sums, v);
}

void RegionView::addOfScan(const InverseDepthImage& image, int row, int column, double along) {
  const Eigen::Vector3d ray = image.ray(row, column);
  const double depth = sine_ * ray.x() + cosine_ * ray.z();
  if (depth < kMinDepth) return;
  const std::size_t pixel = image.index(row, column);
  const double error = static_cast<double>(image.w[pixel]) - q_.dot(ray);
  Sums sums;
  sums.add((cosine_ * ray.x() - sine_ * ray.z()) / depth - u0_, error / depth,
           depth * depth * static_cast<double>(image.weight[pixel]));
  add(sums, along / depth - v0_);
}

void RegionView::add(const Sums& sums, double v) {
  double power = 1.0;
  for (int j = 0; j < 5; ++j, power *= v) {
    for (int i = 0; i + j < 5; ++i) products_[i][j] += sums.u[i] * power;
    for (int i = 0; i + j < 3; ++i) residuals_[i][j] += sums.residual[i] * power;
  }
  rss_ += sums.rss;
}

}  // namespace epcc
