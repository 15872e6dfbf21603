// SPDX-License-Identifier: BSD-3-Clause
// Gated least squares on a checkerboard, then at full resolution.
#include "sensor/block_residuals.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "sensor/ordered_values.h"

namespace epcc {

namespace {

constexpr double kMinValidShare = 0.8;
constexpr double kMinInlierShare = 0.75;
constexpr double kMinSamples = 6.0;
constexpr int kPasses = 4;
constexpr float kFirstGate = 0.25f;  // of the median
constexpr float kGate = 3.2f;        // in 68 % quantiles of the residual
constexpr double kScaleQuantile = 0.68;
constexpr double kAtRest = 1e-4;    // of the gate: a plane that moves less has found its inliers
constexpr double kSteepest = 25.0;  // tan^2 of the angle between ray and normal

/// Sums over the grid of x^i y^j times 1 and times the residual; they separate into columns and rows.
struct GridSums {
  double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0, yy = 0.0;
  double e = 0.0, ex = 0.0, ey = 0.0;

  GridSums(const ColumnSums& columns, int side) {
    for (int column = 0; column < side; ++column) {
      const double t = column - 0.5 * (side - 1);
      const auto count = static_cast<double>(columns.n[column]);
      const auto count_y = static_cast<double>(columns.y[column]);
      const auto error = static_cast<double>(columns.e[column]);
      n += count;
      x += t * count;
      xx += t * t * count;
      y += count_y;
      xy += t * count_y;
      yy += static_cast<double>(columns.yy[column]);
      e += error;
      ex += t * error;
      ey += static_cast<double>(columns.ey[column]);
    }
  }
};

enum class Refit { Impossible, Moved, AtRest };

/// Least squares over the inliers of a plane: the plane of their residuals is added.
Refit refit(const BlockSamples& samples, float gate, SamplePlane& plane) {
  ColumnSums columns;
  sumInliers(samples, plane, gate, columns);
  const GridSums sums(columns, samples.side);
  if (sums.n < kMinSamples) return Refit::Impossible;
  Eigen::Matrix3d a;
  a << sums.xx, sums.xy, sums.x, sums.xy, sums.yy, sums.y, sums.x, sums.y, sums.n;
  Eigen::Matrix3d inverse;
  bool invertible = false;
  a.computeInverseWithCheck(inverse, invertible);
  if (!invertible) return Refit::Impossible;
  const Eigen::Vector3d correction = inverse * Eigen::Vector3d(sums.ex, sums.ey, sums.e);
  plane.tilt_x = static_cast<float>(static_cast<double>(plane.tilt_x) + correction.x());
  plane.tilt_y = static_cast<float>(static_cast<double>(plane.tilt_y) + correction.y());
  plane.value = static_cast<float>(static_cast<double>(plane.value) + correction.z());
  const double moved =
      0.5 * samples.side * (std::abs(correction.x()) + std::abs(correction.y())) + std::abs(correction.z());
  return moved < kAtRest * static_cast<double>(gate) ? Refit::AtRest : Refit::Moved;
}

/// The plane of every second sample of every second row, which begin where all do, as that of all.
SamplePlane planeOfAll(const SamplePlane& plane, int quarter_side, int side) {
  const float shift = 0.5f * static_cast<float>(side - 1) - static_cast<float>(quarter_side - 1);
  SamplePlane result;
  result.tilt_x = 0.5f * plane.tilt_x;
  result.tilt_y = 0.5f * plane.tilt_y;
  result.value = plane.value + shift * (result.tilt_x + result.tilt_y);
  return result;
}

/// The inverse depths of a block's quarter, not in order at first.
struct QuarterDepths {
  std::array<float, kMaxOrdered> values;
  int count = 0;

  explicit QuarterDepths(const BlockSamples& quarter) {
    for (int y = 0; y < quarter.side; ++y) {
      const float* row = quarter.w + y * quarter.pitch;
      if (quarter.valid == quarter.side * quarter.side)
        addRow(row, quarter.side);
      else
        for (int x = 0; x < quarter.side; ++x)
          if (row[x] < kNowhere) addRow(row + x, 1);
    }
  }

  void addRow(const float* row, int length) {
    std::copy(row, row + length, values.begin() + count);
    count += length;
  }

  /// Puts them in order.
  float orderedMedian() {
    orderValues(values.data(), count);
    return values[static_cast<std::size_t>((count - 1) / 2)];
  }
  float median() {
    const auto middle = values.begin() + (count - 1) / 2;
    std::nth_element(values.begin(), middle, values.begin() + count);
    return *middle;
  }
};

/// A block and its plane.
struct FittedBlock {
  double n = 0.0;         // inliers
  double squares = 0.0;   // of their residuals, summed
  double step = 0.0;      // of the inverse depths, if wanted
  double to_depth = 0.0;  // from an inverse depth's difference to the measured depth's
  double depth = 0.0;
  double deviation = 0.0;
};

/// Change of the ray coordinates per pixel at the block.
double pitch(const std::vector<double>& coordinate, int first, int size) {
  const auto i = static_cast<std::size_t>(first);
  return std::abs(coordinate[i + static_cast<std::size_t>(size) - 1] - coordinate[i]) / (size - 1);
}

/// The residuals' size across the surface, metres.
void describe(const InverseDepthImage& image, int row, int column, int size, const SamplePlane& plane, double mean_w,
              FittedBlock& block) {
  const double qu = static_cast<double>(plane.tilt_x) / std::max(pitch(image.across, column, size), 1e-9);
  const double qv = static_cast<double>(plane.tilt_y) / std::max(pitch(image.along, row, size), 1e-9);
  const double tan2 = std::min(kSteepest, (qu * qu + qv * qv) / (mean_w * mean_w));
  const double measured_scale = image.measured_scale[static_cast<std::size_t>(row + size / 2)];
  block.depth = 1.0 / (mean_w * measured_scale);
  block.to_depth = measured_scale * block.depth * block.depth;
  block.deviation = std::sqrt(block.squares / (block.n - 3.0)) * block.to_depth / std::sqrt(1.0 + tan2);
}

std::optional<FittedBlock> fitBlock(const InverseDepthImage& image, int row, int column, int size, bool wants_step,
                                    BlockErrors& errors) {
  assert(size > 1 && size <= kMaxBlock);
  assert(row >= 0 && row + size <= image.height && column >= 0 && column + size <= image.width);
  BlockSamples all;
  gatherBlock(image.w.data() + image.index(row, column), static_cast<std::size_t>(image.width), size, all);
  if (all.valid < kMinValidShare * size * size) return std::nullopt;
  BlockSamples quarter;
  gatherQuarter(all, quarter);
  if (quarter.valid < kMinSamples) return std::nullopt;
  QuarterDepths depths(quarter);
  const float median = wants_step ? depths.orderedMedian() : depths.median();
  subtractCentre(median, all);
  subtractCentre(median, quarter);

  SamplePlane plane;
  float gate = kFirstGate * median;
  const auto rank = static_cast<int>(kScaleQuantile * (quarter.valid - 1));
  for (int pass = 0; pass < kPasses; ++pass) {
    const Refit outcome = refit(quarter, gate, plane);
    if (outcome == Refit::Impossible) return std::nullopt;
    if (outcome == Refit::AtRest && pass > 0) break;
    gate = kGate * residualOfRank(quarter, plane, rank, median);
  }
  plane = planeOfAll(plane, quarter.side, size);
  if (refit(all, gate, plane) == Refit::Impossible) return std::nullopt;

  ErrorSums columns;
  residualsOf(all, plane, gate, errors, columns);
  FittedBlock block;
  double w = 0.0;
  for (int x = 0; x < size; ++x) {
    block.n += static_cast<double>(columns.n[x]);
    block.squares += static_cast<double>(columns.ee[x]);
    w += static_cast<double>(columns.w[x]);
  }
  if (block.n < kMinInlierShare * all.valid || block.n < 8.0) return std::nullopt;
  if (wants_step) block.step = static_cast<double>(smallestGap(depths.values.data(), depths.count));
  describe(image, row, column, size, plane, static_cast<double>(median) + w / block.n, block);
  return block;
}

/// Autocorrelation of the inliers' residuals.
std::array<double, kLags.size()> autocorrelation(const FittedBlock& block, const BlockErrors& errors) {
  const LagSums sums = sumLags(errors);
  const double variance = block.squares / block.n;
  std::array<double, kLags.size()> result{};
  for (std::size_t k = 0; k < kLags.size(); ++k)
    if (sums.pairs[k] > 0.0 && variance > 0.0) result[k] = sums.products[k] / sums.pairs[k] / variance;
  return result;
}

}  // namespace

std::optional<BlockResiduals> measureBlock(const InverseDepthImage& image, int row, int column, int size) {
  BlockErrors errors;
  const auto block = fitBlock(image, row, column, size, true, errors);
  if (!block) return std::nullopt;
  return BlockResiduals{block->depth, block->deviation, block->step * block->to_depth, autocorrelation(*block, errors)};
}

std::optional<double> measureBlockError(const InverseDepthImage& image, int row, int column, int size) {
  BlockErrors errors;
  const auto block = fitBlock(image, row, column, size, false, errors);
  if (!block) return std::nullopt;
  return block->deviation;
}

}  // namespace epcc
