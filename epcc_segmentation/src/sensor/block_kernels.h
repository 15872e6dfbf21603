// SPDX-License-Identifier: BSD-3-Clause
// The sums over a block's samples that its plane comes from, for any vector unit with the same bits. The fit itself is
// in block_plane.cpp.
#pragma once

#include "sensor/block_samples.h"

namespace epcc {

/// w = ray . (x, y, forward), beside the centre that was taken from w.
struct SamplePlane {
  float x = 0.0f;
  float y = 0.0f;
  float forward = 0.0f;
};

/// Per column of samples, over the inliers: what the sums of products of rays and residuals are made of.
struct ColumnSums {
  alignas(64) float n[kMaxBlock];
  alignas(64) float y[kMaxBlock];
  alignas(64) float yy[kMaxBlock];
  alignas(64) float e[kMaxBlock];
  alignas(64) float ey[kMaxBlock];
};

/// The block of `side` pixels, at most kMaxBlock, whose upper left one is at `first`; 0 there is no depth.
void gatherBlock(const float* first, std::size_t row_pitch, int side, BlockSamples& samples);

/// Takes the plane (0, 0, centre) from the samples: single precision is then that of the differences.
void subtractCentre(float centre, const BlockRays& rays, BlockSamples& samples);

/// Sums over the samples with |e| <= gate.
void sumInliers(const BlockSamples& samples, const BlockRays& rays, const SamplePlane& plane, float gate,
                ColumnSums& sums);

/// The smallest |e| that more than `rank` samples do not exceed, to half a percent and rounded up; at most `largest`,
/// at least 2^-24 of that. To order the residuals would take much longer.
float residualOfRank(const BlockSamples& samples, const BlockRays& rays, const SamplePlane& plane, int rank,
                     float largest);

/// Smallest difference of two samples beside each other that is more than rounding, of a block whose centre has not
/// been taken: the step of quantised values, next to nothing for others; 0 if all are equal.
float smallestStep(const BlockSamples& samples);

}  // namespace epcc
