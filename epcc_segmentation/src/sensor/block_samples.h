// SPDX-License-Identifier: BSD-3-Clause
// The pixels of an image block in a small buffer of their own, in rows of whole vectors, and the rays through them.
#pragma once

#include <cstddef>

namespace epcc {

constexpr int kMaxBlock = 32;      // side, pixels
constexpr float kNowhere = 1e30f;  // inverse depth of a pixel without depth
constexpr int kRowOfVector = 16;   // floats: the widest vector
constexpr int kMaxBlockPixels = kMaxBlock * kMaxBlock;

/// A square block, or every second pixel of every second row of one.
struct BlockSamples {
  int side = 0;   ///< samples a row, and rows
  int pitch = 0;  ///< floats from row to row, kRowOfVector or twice that
  int valid = 0;  ///< samples with depth
  /// Inverse depths; kNowhere, or about that, where and beside where is none, and in a vector after the last row.
  alignas(64) float w[kMaxBlockPixels + kRowOfVector];

  void setSide(int samples_a_row);
};

/// The rays (x, y, forward) through the samples, x and forward of a column, y of a row, in units of half the block's
/// width and height. They are seen from the block's middle, so that x and y run from -1 to 1, but for the y of scans.
/// Beside the block they are 0.
struct BlockRays {
  alignas(64) float x[kMaxBlock];
  alignas(64) float forward[kMaxBlock];  ///< 1, or for scans the cosine of the azimuth from the middle
  alignas(64) float y[kMaxBlock];
};

/// Every second pixel of every second row.
void gatherQuarter(const BlockSamples& all, BlockSamples& quarter);
void gatherQuarter(const BlockRays& all, int side, BlockRays& quarter);

}  // namespace epcc
