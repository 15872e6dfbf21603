// SPDX-License-Identifier: BSD-3-Clause
// The flat blocks of a frame, sorted by depth.
#pragma once

#include <array>
#include <vector>

#include "inverse_depth/inverse_depth_image.h"
#include "sensor/block_residuals.h"

namespace epcc {

struct PlacedBlock {
  int row, column;
  BlockResiduals residuals;
};

struct DepthBin {
  double depth = 0.0;      ///< geometric mean, metres
  double deviation = 0.0;  ///< low quantile of the blocks' residuals, metres: clutter can only make them larger
  double step = 0.0;       ///< median of the blocks' depth steps, metres
  double weight = 0.0;     ///< number of blocks
  std::vector<PlacedBlock> blocks;
};

/// At most 120 blocks, evenly spread; three bins per octave, those with fewer than four blocks left out.
std::vector<DepthBin> measureDepthBins(const InverseDepthImage& image, int block_size);

/// Autocorrelation of the residuals of the blocks with less than `roughest` times their bin's deviation: the median in
/// each bin, then the mean by their number of blocks. Bins full of clutter are left out. Not for an empty list.
std::array<double, kLags.size()> correlationOf(const std::vector<DepthBin>& bins, double roughest);

/// Blocks of half the size fit between the clutter: each bin's deviation is lowered to at most 1.1 times what such
/// blocks show. Only for errors whose correlation length is small against the half-size block too.
void guardAgainstClutter(const InverseDepthImage& image, int block_size, std::vector<DepthBin>& bins);

}  // namespace epcc
