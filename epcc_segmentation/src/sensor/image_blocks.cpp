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

namespace {

long tileCount(const InverseDepthImage& image, int block_size) {
  return static_cast<long>(image.width / block_size) * (image.height / block_size);
}

}  // namespace

int ImageBlocks::placeCount(const InverseDepthImage& image, int block_size) {
  return static_cast<int>(std::min<long>(tileCount(image, block_size), kMaxBlocks));
}

BlockPlace ImageBlocks::place(const InverseDepthImage& image, int block_size, int number) {
  const int across = image.width / block_size;
  const long tiles = tileCount(image, block_size);
  const int tile = static_cast<int>(number * tiles / placeCount(image, block_size));
  return {tile / across * block_size, tile % across * block_size, block_size};
}

void ImageBlocks::measure(const InverseDepthImage& image, const Turn& turn) {
  const int count = placeCount(image, block_size_);
  for (int i = turn.phase; i < count; i += turn.phases) {
    ++looked_at_;
    if (const auto block = measureBlock(image, place(image, block_size_, i))) flat_.push_back(*block);
  }
}

}  // namespace epcc
