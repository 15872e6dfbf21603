// SPDX-License-Identifier: BSD-3-Clause
// The sums over a block's samples that its plane and the statistics of its residuals come from, for any vector unit
// with the same bits. The fits themselves are in block_residuals.cpp.
#pragma once

#include <array>

#include "sensor/block_samples.h"

namespace epcc {

/// Lags at which the autocorrelation is measured, pixels.
constexpr std::array<int, 4> kLags = {1, 2, 4, 8};
constexpr int kMaxLag = kLags.back();

/// w = centre of the samples + value + x tilt_x + y tilt_y, x and y in samples from the middle of the block.
struct SamplePlane {
  float tilt_x = 0.0f;
  float tilt_y = 0.0f;
  float value = 0.0f;
};

/// Per column of samples, over the inliers: what the sums of x^i y^j and x^i y^j e over the grid are made of.
struct ColumnSums {
  alignas(64) float n[kMaxBlock];
  alignas(64) float y[kMaxBlock];
  alignas(64) float yy[kMaxBlock];
  alignas(64) float e[kMaxBlock];
  alignas(64) float ey[kMaxBlock];
};

/// The residuals e of a plane, 0 where there is no inlier, and 1 or 0 for inlier or not. Zeros follow each row and the
/// last row, so that any pixel has neighbours at all lags.
struct BlockErrors {
  static constexpr int kRowPitch = kMaxBlock + kRowOfVector;
  int side = 0;
  int width = 0;  ///< the pitch of the samples
  alignas(64) float e[(kMaxBlock + kMaxLag) * kRowPitch];
  alignas(64) float inlier[(kMaxBlock + kMaxLag) * kRowPitch];
};

/// Over the inliers, per column.
struct ErrorSums {
  alignas(64) float n[kMaxBlock];
  alignas(64) float w[kMaxBlock];  ///< without the samples' centre
  alignas(64) float ee[kMaxBlock];
};

/// Sums over the pairs of inliers at each of kLags, rows and columns pooled.
struct LagSums {
  std::array<double, kLags.size()> products{};  ///< of their residuals
  std::array<double, kLags.size()> pairs{};
};

/// The block of `side` pixels, at most kMaxBlock, whose upper left one is at `first`; 0 there is no depth.
void gatherBlock(const float* first, std::size_t row_pitch, int side, BlockSamples& samples);

/// Takes `centre` from the samples.
void subtractCentre(float centre, BlockSamples& samples);

/// Sums over the samples with |e| <= gate.
void sumInliers(const BlockSamples& samples, const SamplePlane& plane, float gate, ColumnSums& sums);

/// The smallest |e| that more than `rank` samples do not exceed, to half a percent and rounded up; at most `largest`,
/// at least 2^-24 of that. To order the residuals would take much longer.
float residualOfRank(const BlockSamples& samples, const SamplePlane& plane, int rank, float largest);

/// The residuals themselves.
void residualsOf(const BlockSamples& samples, const SamplePlane& plane, float gate, BlockErrors& errors,
                 ErrorSums& sums);

LagSums sumLags(const BlockErrors& errors);

/// Smallest gap between ordered positive values that is more than rounding: the step of quantised values, next to
/// nothing for others; 0 if all are equal.
float smallestGap(const float* ordered, int count);

}  // namespace epcc
