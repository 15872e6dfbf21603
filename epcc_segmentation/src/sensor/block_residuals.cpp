// SPDX-License-Identifier: BSD-3-Clause
// Gated least squares on a checkerboard, then at full resolution.
#include "sensor/block_residuals.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "sensor/quantile.h"

namespace epcc {

namespace {

constexpr double kFewestValid = 0.8;
constexpr double kFewestInliers = 0.75;
constexpr int kPasses = 4;
constexpr double kGate = 3.2;       // in 68 % quantiles of the residual
constexpr double kRounding = 1e-6;  // relative, of single precision
constexpr double kSteepest = 25.0;  // tan^2 of the angle between ray and normal

struct Sample {
  double x, y;  // pixels from the block's upper left corner
  double w;
};

/// The residuals of a block, row by row.
using BlockImage = Eigen::Array<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// A block and its plane.
struct FittedBlock {
  std::vector<double> values;  // inverse depths of a quarter of its pixels, sorted
  BlockImage error;            // inliers' residuals, else 0
  BlockImage inlier;           // 1 or 0
  double measured_scale = 1.0;
  double depth = 0.0;
  double r = 0.0;
};

/// w = p0 x + p1 y + p2.
double residual(const Eigen::Vector3d& plane, const Sample& s) {
  return s.w - (plane.x() * s.x + plane.y() * s.y + plane.z());
}

std::optional<Eigen::Vector3d> fit(const std::vector<Sample>& samples, const Eigen::Vector3d& plane, double gate) {
  Eigen::Matrix3d a = Eigen::Matrix3d::Zero();
  Eigen::Vector3d b = Eigen::Vector3d::Zero();
  int n = 0;
  for (const Sample& s : samples) {
    if (std::abs(residual(plane, s)) > gate) continue;
    const Eigen::Vector3d ray(s.x, s.y, 1.0);
    a.noalias() += ray * ray.transpose();
    b += s.w * ray;
    ++n;
  }
  Eigen::Matrix3d inverse;
  bool invertible = false;
  if (n >= 6) a.computeInverseWithCheck(inverse, invertible);
  if (!invertible) return std::nullopt;
  return Eigen::Vector3d(inverse * b);
}

double nextGate(const std::vector<Sample>& samples, const Eigen::Vector3d& plane) {
  std::vector<double> errors;
  errors.reserve(samples.size());
  for (const Sample& s : samples) errors.push_back(std::abs(residual(plane, s)));
  return kGate * quantile(errors, 0.68);
}

/// Autocorrelation of the inliers' residuals, rows and columns pooled.
std::array<double, kLags.size()> autocorrelation(const FittedBlock& block) {
  const auto products = [](const BlockImage& image, int lag) {
    const auto columns = image.cols() - lag;
    const auto rows = image.rows() - lag;
    return (image.leftCols(columns) * image.rightCols(columns)).sum() +
           (image.topRows(rows) * image.bottomRows(rows)).sum();
  };
  const double variance = block.error.square().sum() / block.inlier.sum();
  std::array<double, kLags.size()> result{};
  for (std::size_t k = 0; k < kLags.size(); ++k) {
    const double pairs = products(block.inlier, kLags[k]);
    if (pairs > 0.0 && variance > 0.0) result[k] = products(block.error, kLags[k]) / pairs / variance;
  }
  return result;
}

/// Smallest gap between sorted values that is more than rounding: the step of quantised values, next to nothing for
/// others; 0 if all are equal.
double smallestGap(const std::vector<double>& sorted) {
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    const double gap = sorted[i] - sorted[i - 1];
    if (gap > kRounding * sorted[i]) smallest = std::min(smallest, gap);
  }
  return std::isfinite(smallest) ? smallest : 0.0;
}

/// Change of the ray coordinates per pixel at the block.
double pitch(const std::vector<double>& coordinate, int first, int size) {
  const auto i = static_cast<std::size_t>(first);
  return std::abs(coordinate[i + static_cast<std::size_t>(size) - 1] - coordinate[i]) / (size - 1);
}

std::optional<FittedBlock> fitBlock(const InverseDepthImage& image, int row, int column, int size) {
  FittedBlock block;
  std::vector<double>& values = block.values;
  std::vector<Sample> all, quarter;
  all.reserve(static_cast<std::size_t>(size * size));
  quarter.reserve(all.capacity() / 4);
  values.reserve(all.capacity() / 4);
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      const double w = static_cast<double>(image.w[static_cast<std::size_t>(row + y) * image.width + column + x]);
      if (!(w > 0.0)) continue;
      const Sample sample = {static_cast<double>(x), static_cast<double>(y), w};
      all.push_back(sample);
      if (((x | y) & 1) != 0) continue;
      quarter.push_back(sample);
      values.push_back(w);
    }
  if (static_cast<double>(all.size()) < kFewestValid * size * size || quarter.size() < 6) return std::nullopt;

  std::sort(values.begin(), values.end());
  Eigen::Vector3d plane(0.0, 0.0, values[(values.size() - 1) / 2]);
  double gate = 0.25 * plane.z();
  for (int pass = 0; pass < kPasses; ++pass) {
    const auto next = fit(quarter, plane, gate);
    if (!next) return std::nullopt;
    plane = *next;
    gate = nextGate(quarter, plane);
  }
  const auto full = fit(all, plane, gate);
  if (!full) return std::nullopt;
  plane = *full;

  block.error = BlockImage::Zero(size, size);
  block.inlier = BlockImage::Zero(size, size);
  double squares = 0.0;
  double w_sum = 0.0;
  double n = 0.0;
  for (const Sample& s : all) {
    const double error = residual(plane, s);
    if (std::abs(error) > gate) continue;
    block.error(static_cast<int>(s.y), static_cast<int>(s.x)) = error;
    block.inlier(static_cast<int>(s.y), static_cast<int>(s.x)) = 1.0;
    squares += error * error;
    w_sum += s.w;
    n += 1.0;
  }
  if (n < kFewestInliers * static_cast<double>(all.size()) || n < 8.0) return std::nullopt;

  const double mean_w = w_sum / n;
  const double qu = plane.x() / std::max(pitch(image.across, column, size), 1e-9);
  const double qv = plane.y() / std::max(pitch(image.along, row, size), 1e-9);
  const double tan2 = std::min(kSteepest, (qu * qu + qv * qv) / (mean_w * mean_w));
  block.measured_scale = image.measured_scale[static_cast<std::size_t>(row + size / 2)];
  block.depth = 1.0 / (mean_w * block.measured_scale);
  block.r = std::sqrt(squares / (n - 3.0)) * block.measured_scale * block.depth * block.depth / std::sqrt(1.0 + tan2);
  return block;
}

}  // namespace

std::optional<BlockResiduals> measureBlock(const InverseDepthImage& image, int row, int column, int size) {
  const auto block = fitBlock(image, row, column, size);
  if (!block) return std::nullopt;
  const double step = smallestGap(block->values) * block->measured_scale * block->depth * block->depth;
  return BlockResiduals{block->depth, block->r, step, autocorrelation(*block)};
}

std::optional<double> measureBlockError(const InverseDepthImage& image, int row, int column, int size) {
  const auto block = fitBlock(image, row, column, size);
  if (!block) return std::nullopt;
  return block->r;
}

}  // namespace epcc
