// SPDX-License-Identifier: BSD-3-Clause
// Pixel overlaps of a segmentation's clusters with the ground truth's surfaces.
#pragma once

#include <cstdint>
#include <vector>

#include "datasets/files/image.h"

namespace epcc {

/// Overlap counts O[c][g] over the scored pixels (valid depth, ground truth not ignored). Index 0 stands for
/// unlabelled pixels and for ground that is no plane. Label ids may have gaps: rows and columns are the ids
/// that occur, in ascending order.
class OverlapTable {
 public:
  /// All three arrays have one entry a pixel; depth_valid may be empty (all valid); pixels whose truth is
  /// kIgnoreLabel are not scored. A cluster more than half of
  /// whose pixels lie on ignored ground is not scored, unless it holds at least half of a surface's scored
  /// pixels; its pixels then count as unlabelled. Labels without depth are dropped.
  OverlapTable(const std::vector<std::int32_t>& labels, const std::vector<std::int32_t>& truth,
               const std::vector<std::uint8_t>& depth_valid);

  std::size_t clusterCount() const { return cluster_ids_.size() - 1; }
  std::size_t surfaceCount() const { return surface_ids_.size() - 1; }
  /// Label ids of rows and columns; entry 0 is 0.
  const std::vector<std::int32_t>& clusterIds() const { return cluster_ids_; }
  const std::vector<std::int32_t>& surfaceIds() const { return surface_ids_; }

  /// O[c][g], 0 <= c <= clusterCount(), 0 <= g <= surfaceCount().
  long overlap(std::size_t c, std::size_t g) const { return counts_[c * surface_ids_.size() + g]; }
  /// Scored pixels of a cluster, ground that is no plane included.
  long clusterSize(std::size_t c) const { return cluster_sizes_[c]; }
  /// Scored pixels of a surface, unlabelled ones included.
  long surfaceSize(std::size_t g) const { return surface_sizes_[g]; }
  /// dom(c): the column with the largest overlap, 0 included, ties to the smallest.
  std::size_t dominant(std::size_t c) const;

 private:
  std::vector<std::int32_t> cluster_ids_;
  std::vector<std::int32_t> surface_ids_;
  std::vector<long> counts_;
  std::vector<long> cluster_sizes_;
  std::vector<long> surface_sizes_;
};

}  // namespace epcc
