// SPDX-License-Identifier: BSD-3-Clause
// Blocks at evenly spaced tiles of the image.
#include "sensor/image_blocks.h"

#include <algorithm>

namespace epcc {

void ImageBlocks::begin(int block_size) {
  block_size_ = block_size;
  looked_at_ = 0;
  flat_.clear();
}

void ImageBlocks::measure(const InverseDepthImage& image, const Turn& turn) {
  const int across = image.width / block_size_;
  const int down = image.height / block_size_;
  const long tiles = static_cast<long>(across) * down;
  const int count = static_cast<int>(std::min<long>(tiles, kMaxBlocks));
  for (int i = turn.phase; i < count; i += turn.phases) {
    const int tile = static_cast<int>(i * tiles / count);
    ++looked_at_;
    if (const auto block = measureBlock(image, {tile / across * block_size_, tile % across * block_size_, block_size_}))
      flat_.push_back(*block);
  }
}

}  // namespace epcc
