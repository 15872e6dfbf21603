// SPDX-License-Identifier: BSD-3-Clause
// The parameters of S1 as its kernel wants them.
#pragma once

namespace epcc {

/// Gates and lengths of S1.
struct LineRule {
  float k2 = 0.0f;       ///< largest squared residual, sigma_w^2
  float max_rss = 0.0f;  ///< of the samples that start a line, sigma_w^2
  int min_samples = 0;   ///< that start a line
  int reach = 0;         ///< from one sample of a line to the next, pixels
  int ring_mask = 0;     ///< positions of the ring of rejected samples - 1
};

}  // namespace epcc
