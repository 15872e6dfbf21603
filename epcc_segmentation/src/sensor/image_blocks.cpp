// SPDX-License-Identifier: BSD-3-Clause
// Blocks at evenly spaced tiles of the image.
#include "sensor/image_blocks.h"

#include <algorithm>

namespace epcc {

void ImageBlocks::begin(int block_size) {
  block_size_ = block_size;
  looked_at_ = 0;
  halves_done_ = 0;
  blocks_.clear();
}

void ImageBlocks::measure(const InverseDepthImage& image, const Turn& turn) {
  const int across = image.width / block_size_;
  const int down = image.height / block_size_;
  const long tiles = static_cast<long>(across) * down;
  const int count = static_cast<int>(std::min<long>(tiles, kMaxBlocks));
  for (int i = turn.phase; i < count; i += turn.phases) {
    const int tile = static_cast<int>(i * tiles / count);
    const int row = tile / across * block_size_;
    const int column = tile % across * block_size_;
    ++looked_at_;
    if (const auto block = measureBlock(image, row, column, block_size_))
      blocks_.push_back({row, column, *block, {kUnmeasured, kUnmeasured}});
  }
}

void ImageBlocks::measureHalves(const InverseDepthImage& image) {
  const int half = block_size_ / 2;
  for (; halves_done_ < blocks_.size(); ++halves_done_) {
    PlacedBlock& block = blocks_[halves_done_];
    for (int k = 0; k < 2; ++k)
      block.half_deviations[static_cast<std::size_t>(k)] =
          measureBlockError(image, block.row + k * half, block.column + k * half, half).value_or(kUnmeasured);
  }
}

}  // namespace epcc
