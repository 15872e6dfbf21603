// SPDX-License-Identifier: BSD-3-Clause
// The flat blocks sorted by depth.
#pragma once

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "sensor/image_blocks.h"

namespace epcc {

struct DepthBin {
  double depth = 0.0;      ///< geometric mean, metres
  double deviation = 0.0;  ///< low quantile of the blocks' residuals, metres: clutter can only make them larger
  double step = 0.0;       ///< median of the blocks' depth steps, metres
  double weight = 0.0;     ///< number of blocks
  std::size_t begin = 0;   ///< of its blocks in the order of depth
  std::size_t end = 0;
};

/// Three bins per octave, those with fewer than four blocks left out. Keeps its memory.
class DepthBins {
 public:
  DepthBins();
  /// The blocks are looked up again by the functions below, and must stay; the halves alone may be added.
  void sort(const std::vector<PlacedBlock>& blocks);
  bool empty() const { return bins_.empty(); }
  std::size_t size() const { return bins_.size(); }
  const DepthBin& operator[](std::size_t i) const { return bins_[i]; }
  /// Blocks in all bins.
  std::size_t blockCount() const;

  /// Autocorrelation of the residuals of the blocks with less than `roughest` times their bin's deviation: the median
  /// in each bin, then the mean by their number of blocks. Bins full of clutter are left out. Not without bins.
  std::array<double, kLags.size()> correlation(double roughest);

  /// Blocks of half the size fit between the clutter: each bin's deviation is lowered to at most 1.1 times what such
  /// blocks show. Only for errors whose correlation length is small against the half-size block too.
  void guardAgainstClutter();

 private:
  struct Place {
    int bin;
    int block;
    bool operator<(const Place& other) const { return bin != other.bin ? bin < other.bin : block < other.block; }
  };

  const PlacedBlock& block(std::size_t i) const { return (*blocks_)[static_cast<std::size_t>(places_[i].block)]; }
  void summarize(DepthBin& bin);
  double clutterLimit();
  double correlationAt(std::size_t lag, double roughest, double clutter_limit);

  const std::vector<PlacedBlock>* blocks_ = nullptr;
  std::vector<Place> places_;  // of the blocks, by bin
  std::vector<DepthBin> bins_;
  std::vector<double> values_;  // to find quantiles of
};

}  // namespace epcc
