// SPDX-License-Identifier: BSD-3-Clause
// The layout of a block's samples, and the thinning of them.
#include "sensor/block_samples.h"

#include <algorithm>
#include <cassert>

namespace epcc {

void BlockSamples::setSide(int samples_a_row) {
  assert(samples_a_row > 0 && samples_a_row <= kMaxBlock);
  side = samples_a_row;
  pitch = side <= kRowOfVector ? kRowOfVector : 2 * kRowOfVector;
}

void gatherQuarter(const BlockSamples& all, BlockSamples& quarter) {
  quarter.setSide(all.side / 2);
  const bool full = all.valid == all.side * all.side;
  quarter.valid = full ? quarter.side * quarter.side : 0;
  for (int y = 0; y < quarter.side; ++y) {
    const float* pixel = all.w + 2 * y * all.pitch;
    float* row = quarter.w + y * quarter.pitch;
    for (int x = 0; x < quarter.side; ++x) row[x] = pixel[2 * x];
    if (!full)
      quarter.valid += static_cast<int>(std::count_if(row, row + quarter.side, [](float w) { return w < kNowhere; }));
    std::fill(row + quarter.side, row + quarter.pitch, kNowhere);
  }
}

void gatherQuarter(const BlockRays& all, int side, BlockRays& quarter) {
  quarter = {};
  for (int i = 0; i < side / 2; ++i) {
    quarter.x[i] = all.x[2 * i];
    quarter.forward[i] = all.forward[2 * i];
    quarter.y[i] = all.y[2 * i];
  }
}

}  // namespace epcc
