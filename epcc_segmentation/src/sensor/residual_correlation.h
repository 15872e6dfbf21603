// SPDX-License-Identifier: BSD-3-Clause
// Autocorrelation of what quadrics leave of blocks: for reports, the estimate does not need it.
#pragma once

#include <vector>

#include "inverse_depth/inverse_depth_image.h"
#include "sensor/image_blocks.h"

namespace epcc {

/// Sums over the blocks of images of one camera.
class ResidualCorrelation {
 public:
  explicit ResidualCorrelation(int block_size);
  void add(const InverseDepthImage& image);
  /// At lags of 0, 1, ... half of a block: the median over the blocks, rows and columns pooled. Empty without blocks.
  std::vector<double> measured() const;
  /// The same of grain and blotches of these variances.
  std::vector<double> expected(double grain, double blotches, double length) const;

 private:
  void addBlock(const FittedBlock& block);

  int side_;
  std::vector<std::vector<double>> by_lag_;  // of each block
};

}  // namespace epcc
