// SPDX-License-Identifier: BSD-3-Clause
// Gated least squares on a checkerboard, then at full resolution.
#include "sensor/block_residuals.h"

#include <Eigen/LU>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "sensor/quantile.h"

namespace epcc {

namespace {

constexpr double kMinValidShare = 0.8;
constexpr double kMinInlierShare = 0.75;
constexpr int kMaxBlock = 32;  // side, pixels
constexpr int kPasses = 4;
constexpr double kGate = 3.2;  // in 68 % quantiles of the residual
constexpr double kScaleQuantile = 0.68;
constexpr double kScaleOctaves = 24.0;  // of the inverse depth: what single precision tells
constexpr int kHalvings = 12;
constexpr double kNowhere = 1e30;   // inverse depth of a pixel without depth
constexpr double kRounding = 1e-6;  // relative, of single precision
constexpr double kSteepest = 25.0;  // tan^2 of the angle between ray and normal

/// A value per pixel of a block, row by row, on the stack.
using BlockImage = Eigen::Array<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor, kMaxBlock, kMaxBlock>;

/// The pixels of a square block, or every second one of every second row.
struct Samples {
  BlockImage w;                                                      // inverse depths, kNowhere where there is none
  Eigen::Matrix<double, Eigen::Dynamic, 3, 0, kMaxBlock, 3> powers;  // 1, t, t^2 of the coordinate t in pixels

  Samples(const InverseDepthImage& image, int row, int column, int size, int stride) {
    assert(size > 1 && size <= kMaxBlock);
    assert(row >= 0 && row + size <= image.height && column >= 0 && column + size <= image.width);
    const int count = size / stride;
    w.resize(count, count);
    for (int y = 0; y < count; ++y) {
      const float* pixel = image.w.data() + image.index(row + y * stride, column);
      for (int x = 0; x < count; ++x) {
        const auto value = static_cast<double>(pixel[x * stride]);
        w(y, x) = value > 0.0 ? value : kNowhere;
      }
    }
    powers.resize(count, 3);
    powers.col(0).setOnes();
    powers.col(1).setLinSpaced(count, 0.0, stride * (count - 1.0));
    powers.col(2) = powers.col(1).cwiseAbs2();
  }

  /// The inverse depths there are.
  std::vector<float> values() const {
    std::vector<float> result;
    result.reserve(static_cast<std::size_t>(w.size()));
    for (Eigen::Index i = 0; i < w.size(); ++i)
      if (w.data()[i] < kNowhere) result.push_back(static_cast<float>(w.data()[i]));
    return result;
  }

  /// Residuals of w = plane . (x, y, 1); enormous where there is no pixel.
  BlockImage residuals(const Eigen::Vector3d& plane) const {
    BlockImage error(w.rows(), w.cols());
    for (Eigen::Index y = 0; y < error.rows(); ++y)
      error.row(y) = w.row(y) - plane.x() * powers.col(1).transpose().array() - (plane.y() * powers(y, 1) + plane.z());
    return error;
  }
};

/// 1 where the error is at most `gate`, else 0.
BlockImage inliers(const BlockImage& error, double gate) {
  BlockImage result(error.rows(), error.cols());
  for (Eigen::Index i = 0; i < error.size(); ++i) result.data()[i] = std::abs(error.data()[i]) <= gate ? 1.0 : 0.0;
  return result;
}

/// Least squares over the pixels where `inlier` is 1. The sums over a grid separate into rows and columns.
std::optional<Eigen::Vector3d> fit(const Samples& samples, const BlockImage& inlier) {
  const auto& t = samples.powers;
  const Eigen::Matrix<double, Eigen::Dynamic, 3, 0, kMaxBlock, 3> rows = inlier.matrix().lazyProduct(t);
  const Eigen::Matrix<double, Eigen::Dynamic, 2, 0, kMaxBlock, 2> rows_w =
      (inlier * samples.w).matrix().eval().lazyProduct(t.leftCols<2>());
  const Eigen::Matrix3d m = t.transpose().lazyProduct(rows);  // sum of y^i x^j
  const Eigen::Matrix2d mw = t.leftCols<2>().transpose().lazyProduct(rows_w);
  if (m(0, 0) < 6.0) return std::nullopt;
  Eigen::Matrix3d a;
  a << m(0, 2), m(1, 1), m(0, 1), m(1, 1), m(2, 0), m(1, 0), m(0, 1), m(1, 0), m(0, 0);
  Eigen::Matrix3d inverse;
  bool invertible = false;
  a.computeInverseWithCheck(inverse, invertible);
  if (!invertible) return std::nullopt;
  return Eigen::Vector3d(inverse * Eigen::Vector3d(mw(0, 1), mw(1, 0), mw(0, 0)));
}

/// The 68 % quantile of the errors of `count` pixels, to half a percent: halvings of an interval of its logarithm.
/// quantile() orders the values, and with it the measuring of a frame takes a sixth longer.
double scaleOf(const BlockImage& error, std::size_t count, double largest) {
  const Eigen::Array<float, Eigen::Dynamic, 1, 0, kMaxBlock * kMaxBlock, 1> size =
      Eigen::Map<const Eigen::ArrayXd>(error.data(), error.size()).abs().cast<float>();
  const auto rank = static_cast<int>(kScaleQuantile * static_cast<double>(count - 1));
  double low = std::log2(largest) - kScaleOctaves;
  double high = std::log2(largest);
  for (int step = 0; step < kHalvings; ++step) {
    const double middle = (low + high) / 2.0;
    const auto limit = static_cast<float>(std::exp2(middle));
    int below = 0;
    for (Eigen::Index i = 0; i < size.size(); ++i) below += size.data()[i] <= limit ? 1 : 0;
    (below > rank ? high : low) = middle;
  }
  return std::exp2(high);
}

/// A block and its plane.
struct FittedBlock {
  std::vector<float> values;  // inverse depths of a quarter of its pixels
  BlockImage error;           // inliers' residuals, else 0
  BlockImage inlier;          // 1 or 0
  double measured_scale = 1.0;
  double depth = 0.0;
  double deviation = 0.0;
};

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

/// Smallest gap between values that is more than rounding: the step of quantised values, next to nothing for others; 0
/// if all are equal.
double smallestGap(std::vector<float> values) {
  std::sort(values.begin(), values.end());
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < values.size(); ++i) {
    const double gap = static_cast<double>(values[i]) - static_cast<double>(values[i - 1]);
    if (gap > kRounding * static_cast<double>(values[i])) smallest = std::min(smallest, gap);
  }
  return std::isfinite(smallest) ? smallest : 0.0;
}

/// Change of the ray coordinates per pixel at the block.
double pitch(const std::vector<double>& coordinate, int first, int size) {
  const auto i = static_cast<std::size_t>(first);
  return std::abs(coordinate[i + static_cast<std::size_t>(size) - 1] - coordinate[i]) / (size - 1);
}

std::optional<FittedBlock> fitBlock(const InverseDepthImage& image, int row, int column, int size) {
  const Samples all(image, row, column, size, 1);
  const auto valid = static_cast<double>((all.w < kNowhere).count());
  if (valid < kMinValidShare * size * size) return std::nullopt;
  const Samples quarter(image, row, column, size, 2);
  FittedBlock block;
  block.values = quarter.values();
  if (block.values.size() < 6) return std::nullopt;

  const auto median = static_cast<double>(quantile(block.values, 0.5));
  Eigen::Vector3d plane(0.0, 0.0, median);
  double gate = 0.25 * median;
  BlockImage error = quarter.residuals(plane);
  for (int pass = 0; pass < kPasses; ++pass) {
    const auto next = fit(quarter, inliers(error, gate));
    if (!next) return std::nullopt;
    plane = *next;
    error = quarter.residuals(plane);
    gate = kGate * scaleOf(error, block.values.size(), median);
  }
  const auto full = fit(all, inliers(all.residuals(plane), gate));
  if (!full) return std::nullopt;
  plane = *full;

  error = all.residuals(plane);
  block.inlier = inliers(error, gate);
  block.error = block.inlier * error;
  const double n = block.inlier.sum();
  if (n < kMinInlierShare * valid || n < 8.0) return std::nullopt;

  const double mean_w = (block.inlier * all.w).sum() / n;
  const double qu = plane.x() / std::max(pitch(image.across, column, size), 1e-9);
  const double qv = plane.y() / std::max(pitch(image.along, row, size), 1e-9);
  const double tan2 = std::min(kSteepest, (qu * qu + qv * qv) / (mean_w * mean_w));
  block.measured_scale = image.measured_scale[static_cast<std::size_t>(row + size / 2)];
  block.depth = 1.0 / (mean_w * block.measured_scale);
  block.deviation = std::sqrt(block.error.square().sum() / (n - 3.0)) * block.measured_scale * block.depth *
                    block.depth / std::sqrt(1.0 + tan2);
  return block;
}

}  // namespace

std::optional<BlockResiduals> measureBlock(const InverseDepthImage& image, int row, int column, int size) {
  const auto block = fitBlock(image, row, column, size);
  if (!block) return std::nullopt;
  const double step = smallestGap(block->values) * block->measured_scale * block->depth * block->depth;
  return BlockResiduals{block->depth, block->deviation, step, autocorrelation(*block)};
}

std::optional<double> measureBlockError(const InverseDepthImage& image, int row, int column, int size) {
  const auto block = fitBlock(image, row, column, size);
  if (!block) return std::nullopt;
  return block->deviation;
}

}  // namespace epcc
