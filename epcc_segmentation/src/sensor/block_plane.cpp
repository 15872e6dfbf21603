// SPDX-License-Identifier: BSD-3-Clause
// Gated least squares on a checkerboard, then at full resolution.
#include "sensor/block_plane.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace epcc {

namespace {

constexpr double kMinValidShare = 0.8;
constexpr double kMinSamples = 6.0;
constexpr int kFitPasses = 4;
constexpr float kFirstGate = 0.25f;  // of the median
constexpr float kGate = 3.2f;        // in 68 % quantiles of the residual
constexpr double kScaleQuantile = 0.68;
constexpr double kAtRest = 1e-4;    // of the gate: a plane that moves less has found its inliers
constexpr double kSteepest = 25.0;  // tan^2 of the angle between ray and normal

/// Half of the width and of the height of a block in ray coordinates, and the y of its middle in such halves.
struct Extent {
  double x, y;
  double middle_y;
};

double halfRange(const double* value, int count) {
  const auto [least, most] = std::minmax_element(value, value + count);
  return std::max(0.5 * (*most - *least), 1e-9);
}

Extent findRays(const InverseDepthImage& image, const BlockPlace& place, BlockRays& rays) {
  const auto side = static_cast<std::size_t>(place.side);
  const auto row = static_cast<std::size_t>(place.row);
  const auto column = static_cast<std::size_t>(place.column);
  const double* across = image.across.data() + column;
  const double* forward = image.forward.data() + column;
  const double* along = image.along.data() + row;
  std::array<double, kMaxBlock> x{};
  const double middle_x = across[side / 2];
  const double middle_forward = forward[side / 2];
  rays = {};
  for (std::size_t i = 0; i < side; ++i) {
    // (u - u0, 1), and for scans, whose (across, forward) are unit vectors, sine and cosine of the azimuth between.
    x[i] = image.planar_rows ? across[i] - middle_x : across[i] * middle_forward - forward[i] * middle_x;
    const double cosine = across[i] * middle_x + forward[i] * middle_forward;
    rays.forward[i] = image.planar_rows ? 1.0f : static_cast<float>(cosine);
  }
  Extent half = {halfRange(x.data(), place.side), halfRange(along, place.side), 0.0};
  const double middle_y = 0.5 * (along[0] + along[side - 1]);
  // A scan's tangents stay as they are: its constant is no plane.
  const double origin_y = image.planar_rows ? middle_y : 0.0;
  half.middle_y = (middle_y - origin_y) / half.y;
  for (std::size_t i = 0; i < side; ++i) {
    rays.x[i] = static_cast<float>(x[i] / half.x);
    rays.y[i] = static_cast<float>((along[i] - origin_y) / half.y);
  }
  return half;
}

/// Sums over the samples of products of rays and residuals; they separate into columns and rows.
struct RaySums {
  double n = 0.0;
  Eigen::Matrix3d rays = Eigen::Matrix3d::Zero();
  Eigen::Vector3d errors = Eigen::Vector3d::Zero();

  RaySums(const ColumnSums& columns, const BlockRays& block, int side) {
    double xx = 0.0, xy = 0.0, xf = 0.0, yy = 0.0, yf = 0.0, ff = 0.0, ex = 0.0, ey = 0.0, ef = 0.0;
    for (int column = 0; column < side; ++column) {
      const auto x = static_cast<double>(block.x[column]);
      const auto forward = static_cast<double>(block.forward[column]);
      const auto count = static_cast<double>(columns.n[column]);
      const auto count_y = static_cast<double>(columns.y[column]);
      const auto error = static_cast<double>(columns.e[column]);
      n += count;
      xx += x * x * count;
      xf += x * forward * count;
      ff += forward * forward * count;
      xy += x * count_y;
      yf += forward * count_y;
      yy += static_cast<double>(columns.yy[column]);
      ex += x * error;
      ef += forward * error;
      ey += static_cast<double>(columns.ey[column]);
    }
    rays << xx, xy, xf, xy, yy, yf, xf, yf, ff;
    errors << ex, ey, ef;
  }
};

enum class Refit { Impossible, Moved, AtRest };

/// Least squares over the inliers of a plane: the plane of their residuals is added.
Refit refit(const BlockSamples& samples, const BlockRays& rays, float gate, SamplePlane& plane) {
  ColumnSums columns;
  sumInliers(samples, rays, plane, gate, columns);
  const RaySums sums(columns, rays, samples.side);
  if (sums.n < kMinSamples) return Refit::Impossible;
  Eigen::Matrix3d inverse;
  bool invertible = false;
  sums.rays.computeInverseWithCheck(inverse, invertible);
  if (!invertible) return Refit::Impossible;
  const Eigen::Vector3d correction = inverse * sums.errors;
  plane.x = static_cast<float>(static_cast<double>(plane.x) + correction.x());
  plane.y = static_cast<float>(static_cast<double>(plane.y) + correction.y());
  plane.forward = static_cast<float>(static_cast<double>(plane.forward) + correction.z());
  return correction.cwiseAbs().sum() < kAtRest * static_cast<double>(gate) ? Refit::AtRest : Refit::Moved;
}

constexpr int kMedianSamples = 64;

/// Of every second sample of a block's quarter each way: it only has to be near the plane.
float roughMedian(const BlockSamples& quarter) {
  std::array<float, kMedianSamples> values;
  int count = 0;
  for (int y = 0; y < quarter.side; y += 2)
    for (int x = 0; x < quarter.side; x += 2) {
      const float w = quarter.w[y * quarter.pitch + x];
      if (w < kNowhere) values[static_cast<std::size_t>(count++)] = w;
    }
  if (count == 0) return 0.0f;
  const auto middle = values.begin() + (count - 1) / 2;
  std::nth_element(values.begin(), middle, values.begin() + count);
  return *middle;
}

/// The plane of most of a block's quarter, and the gate for the others.
bool fitQuarter(const BlockSamples& quarter, const BlockRays& rays, float median, SamplePlane& plane, float& gate) {
  gate = kFirstGate * median;
  const auto rank = static_cast<int>(kScaleQuantile * (quarter.valid - 1));
  for (int pass = 0; pass < kFitPasses; ++pass) {
    const Refit outcome = refit(quarter, rays, gate, plane);
    if (outcome == Refit::Impossible) return false;
    if (outcome == Refit::AtRest && pass > 0) break;
    gate = kGate * residualOfRank(quarter, rays, plane, rank, median);
  }
  return true;
}

}  // namespace

bool fitBlock(const InverseDepthImage& image, const BlockPlace& place, FittedBlock& block, double full_share) {
  const int side = place.side;
  assert(side > 1 && side <= kMaxBlock);
  assert(place.row >= 0 && place.row + side <= image.height && place.column >= 0 && place.column + side <= image.width);
  BlockSamples& all = block.samples;
  gatherBlock(image.w.data() + image.index(place.row, place.column), static_cast<std::size_t>(image.width), side, all);
  if (all.valid < kMinValidShare * full_share * side * side) return false;
  BlockSamples quarter;
  gatherQuarter(all, quarter);
  const float median = roughMedian(quarter);
  if (!(median > 0.0f)) return false;
  block.step = static_cast<double>(smallestStep(all));
  const Extent half = findRays(image, place, block.rays);
  BlockRays quarter_rays;
  gatherQuarter(block.rays, side, quarter_rays);
  subtractCentre(median, block.rays, all);
  subtractCentre(median, quarter_rays, quarter);

  block.plane = {};
  if (!fitQuarter(quarter, quarter_rays, median, block.plane, block.gate)) return false;
  if (refit(all, block.rays, block.gate, block.plane) == Refit::Impossible) return false;

  const double middle_w =
      static_cast<double>(median + block.plane.forward) + static_cast<double>(block.plane.y) * half.middle_y;
  const double mean_w = std::max(middle_w, 1e-12);
  block.w = middle_w;
  const double qu = static_cast<double>(block.plane.x) / half.x;
  const double qv = static_cast<double>(block.plane.y) / half.y;
  block.tan2 = std::min(kSteepest, (qu * qu + qv * qv) / (mean_w * mean_w));
  const double measured_scale = image.measured_scale[static_cast<std::size_t>(place.row + side / 2)];
  block.depth = 1.0 / (mean_w * measured_scale);
  block.to_depth = measured_scale * block.depth * block.depth;
  return true;
}

}  // namespace epcc
