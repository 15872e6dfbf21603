// SPDX-License-Identifier: BSD-3-Clause
// The pixels of one row that lie on the planes of the samples beside them, in vectors.
#pragma once

#include <cstdint>

namespace epcc {

struct InverseDepthNoise;

/// A plane w = q . ray in single precision; that of label 0 fits nothing.
struct PixelPlane {
  float across = 0.0f, along = 0.0f, forward = 0.0f;  ///< q
  float slope = 0.0f;                                 ///< see slopeFactor()
  float inverse_root_slope = 0.0f;
};

/// Rays in single precision: across and forward per column, along per row.
struct RaysOfPixels {
  const float *across, *along, *forward;
};

/// Blocks of one label side by side: their first pixels and the last one's end, and their labels.
struct BlockRuns {
  int count;
  const int* begins;  ///< count + 1
  const std::int32_t* labels;
};

/// A row of pixels, with the runs of the blocks that it crosses and the planes of all labels.
struct PixelRow {
  const float* w;
  const float *across, *forward;  ///< rays, per column
  float along;
  float scale;       ///< measured inverse depth = w * scale
  bool perspective;  ///< forward and scale are 1
  int width;
  BlockRuns runs;
  const PixelPlane* planes;  ///< per label
  const InverseDepthNoise* noise;
  float max_residual2;  ///< in sigma^2
};

/// label = that of the sample if (w - q . ray)^2 <= max_residual^2 slope sigma_w^2, else 0. Adds the pixels to those of
/// each label but 0.
void labelMembers(const PixelRow& row, std::int32_t* labels, long* pixels);

}  // namespace epcc
