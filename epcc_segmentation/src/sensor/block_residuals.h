// SPDX-License-Identifier: BSD-3-Clause
// Robust plane of one image block and the statistics of its residuals.
#pragma once

#include <array>
#include <optional>

#include "inverse_depth/inverse_depth_image.h"
#include "sensor/block_kernels.h"

namespace epcc {

struct BlockResiduals {
  double depth = 0.0;      ///< measured depth at the block, metres
  double deviation = 0.0;  ///< residual standard deviation across the surface, metres
  double step = 0.0;       ///< smallest difference of two depths, metres: the step of a quantised depth
  std::array<double, kLags.size()> correlation{};
};

/// Fits the block with upper left corner (row, column) and side `size`; nothing if less than 80 % of it is valid or
/// less than 75 % of that lies on one plane.
std::optional<BlockResiduals> measureBlock(const InverseDepthImage& image, int row, int column, int size);

/// Its deviation alone.
std::optional<double> measureBlockError(const InverseDepthImage& image, int row, int column, int size);

}  // namespace epcc
