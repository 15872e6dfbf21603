// SPDX-License-Identifier: BSD-3-Clause
// The flat blocks of a frame, or of a part of it.
#pragma once

#include <cstddef>
#include <vector>

#include "inverse_depth/inverse_depth_image.h"
#include "sensor/block_residuals.h"

namespace epcc {

constexpr int kMaxBlocks = 150;

/// The share of the blocks that one frame measures: those whose number leaves `phase` when divided by `phases`.
struct Turn {
  int phase = 0;
  int phases = 1;
};

/// Blocks spread evenly over the image, at most kMaxBlocks. Measured a turn at a time, on one image or on several of
/// the same size; keeps its memory.
class ImageBlocks {
 public:
  ImageBlocks() { flat_.reserve(kMaxBlocks); }
  /// Forgets what was measured.
  void begin(int block_size);
  void measure(const InverseDepthImage& image, const Turn& turn);

  /// Places of the blocks, flat or not.
  static int placeCount(const InverseDepthImage& image, int block_size);
  static BlockPlace place(const InverseDepthImage& image, int block_size, int number);
  /// What is valid of the fullest block: all but where the sensor misses pixels everywhere, on flat walls too. At least
  /// a half, for a frame with fewer is ScatteredPixels' business.
  static double fullShare(const InverseDepthImage& image, int block_size);

  int blockSize() const { return block_size_; }
  const std::vector<BlockResiduals>& flat() const { return flat_; }
  /// How many blocks were looked at, flat or not.
  std::size_t lookedAt() const { return looked_at_; }

 private:
  int block_size_ = 0;
  std::size_t looked_at_ = 0;
  std::vector<BlockResiduals> flat_;
};

}  // namespace epcc
