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

double ImageBlocks::fullShare(const InverseDepthImage& image, int block_size) {
  const int count = placeCount(image, block_size), pixels = block_size * block_size;
  int most = pixels / 2;
  for (int i = 0; i < count && most < pixels; ++i) {
    const BlockPlace block = place(image, block_size, i);
    int valid = 0;
    for (int row = block.row; row < block.row + block.side; ++row) {
      const float* w = image.w.data() + image.index(row, block.column);
      for (int column = 0; column < block.side; ++column) valid += static_cast<int>(w[column] > 0.0f);
    }
    most = std::max(most, valid);
  }
  return static_cast<double>(most) / pixels;
}

void ImageBlocks::measure(const InverseDepthImage& image, const Turn& turn) {
  const int count = placeCount(image, block_size_);
  const double full_share = fullShare(image, block_size_);
  for (int i = turn.phase; i < count; i += turn.phases) {
    ++looked_at_;
    if (const auto block = measureBlock(image, place(image, block_size_, i), full_share)) flat_.push_back(*block);
  }
}

}  // namespace epcc
