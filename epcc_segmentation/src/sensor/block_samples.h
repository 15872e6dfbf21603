// SPDX-License-Identifier: BSD-3-Clause
// The pixels of an image block in a small buffer of their own, in rows of whole vectors.
#pragma once

#include <cstddef>

namespace epcc {

constexpr int kMaxBlock = 32;      // side, pixels
constexpr float kNowhere = 1e30f;  // inverse depth of a pixel without depth
constexpr int kRowOfVector = 16;   // floats: the widest vector
constexpr int kMaxBlockPixels = kMaxBlock * kMaxBlock;

/// A square block, or every second pixel of every second row of one.
struct BlockSamples {
  int side = 0;                          ///< samples a row, and rows
  int pitch = 0;                         ///< floats from row to row, kRowOfVector or twice that
  int valid = 0;                         ///< samples with depth
  float centre = 0.0f;                   ///< has been taken from w: single precision is then that of the differences
  alignas(64) float w[kMaxBlockPixels];  ///< inverse depths; kNowhere, or about that, where and beside where is none

  void setSide(int samples_a_row);
};

/// Every second pixel of every second row.
void gatherQuarter(const BlockSamples& all, BlockSamples& quarter);

}  // namespace epcc
