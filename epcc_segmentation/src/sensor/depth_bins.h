// SPDX-License-Identifier: BSD-3-Clause
// The flat blocks sorted by depth.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "sensor/image_blocks.h"

namespace epcc {

/// What is held of sigma_z(z), at first but its growth.
struct SigmaShape {
  double a = 0.0, b = 0.0;
  bool known = false;
  double operator()(double z) const { return known ? std::hypot(a, b * z * z) : z * std::sqrt(z); }
};

struct DepthBin {
  double depth = 0.0;      ///< geometric mean, metres
  double deviation = 0.0;  ///< low quantile of the blocks' residuals, metres: clutter can only make them larger
  double step = 0.0;       ///< median of the blocks' depth steps, metres
  bool agrees = false;     ///< the deviation is that of most blocks
  std::size_t begin = 0;   ///< of its blocks in the order of depth
  std::size_t end = 0;

  double weight() const { return static_cast<double>(end - begin); }
};

/// Three bins per octave, those with fewer than four blocks left out. Keeps its memory.
class DepthBins {
 public:
  DepthBins();
  /// The blocks are looked up again by the functions below, and must stay.
  void sort(const std::vector<BlockResiduals>& blocks);
  bool empty() const { return bins_.empty(); }
  std::size_t size() const { return bins_.size(); }
  const DepthBin& operator[](std::size_t i) const { return bins_[i]; }
  /// Blocks in all bins.
  std::size_t blockCount() const;

  /// Each bin's deviation, and whether most of its blocks agree with it; the blocks' depths differ within it, and are
  /// made up for by `sigma`. axial: see BlockResiduals::deviationAlong.
  void findDeviations(const SigmaShape& sigma, double axial);
  /// Median of BlockResiduals::kept of the blocks with at most twice their bin's deviation. Bins full of clutter are
  /// left out. Not without bins.
  std::array<double, kScales - 1> kept(const SigmaShape& sigma, double axial);
  /// Low quantile of BlockResiduals::bent, over that of white error on planes: curved surfaces and clutter can only
  /// make it larger. Not without bins.
  double bentOverChance();
  /// Blocks of half the size fit between the clutter: the deviation of each bin whose blocks do not agree is lowered to
  /// at most 1.1 times what such blocks show at its depth. kept: share of the mean square in one of the bins' blocks
  /// that is left in theirs.
  void guardAgainstClutter(const std::vector<BlockResiduals>& halves, double axial, double kept);

 private:
  struct Place {
    int bin;
    int block;
    bool operator<(const Place& other) const { return bin != other.bin ? bin < other.bin : block < other.block; }
  };

  const BlockResiduals& block(std::size_t i) const { return (*blocks_)[static_cast<std::size_t>(places_[i].block)]; }
  void describe(DepthBin& bin);
  double clutterLimit(const SigmaShape& sigma);

  const std::vector<BlockResiduals>* blocks_ = nullptr;
  std::vector<Place> places_;  // of the blocks, by bin
  std::vector<DepthBin> bins_;
  std::vector<double> values_;  // to find quantiles of
};

}  // namespace epcc
