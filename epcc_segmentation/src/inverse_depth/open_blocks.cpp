// SPDX-License-Identifier: BSD-3-Clause
// Blocks are counted, and what lies outside of them is hidden.
#include "inverse_depth/open_blocks.h"

#include <algorithm>
#include <cstddef>

namespace epcc {

namespace {

constexpr int kBlock = 8;           // samples
constexpr int kEnoughOfBlock = 16;  // of 64

}  // namespace

// Single samples that miss their plane are of no surface: only blocks with enough of them, and those around, are
// segmented anew.
bool OpenBlocks::mark(const InverseDepthImage& image, const RegionMap& map) {
  const int columns = (image.width + kBlock - 1) / kBlock, rows = (image.height + kBlock - 1) / kBlock;
  const auto pitch = static_cast<std::size_t>(columns);
  counts_.assign(pitch * static_cast<std::size_t>(rows), 0);
  for (int row = 0; row < image.height; ++row) {
    const std::int32_t* labels = map.labels.data() + image.index(row, 0);
    const float* w = image.w.data() + image.index(row, 0);
    int* counts = counts_.data() + static_cast<std::size_t>(row / kBlock) * pitch;
    for (int column = 0; column < image.width; column += kBlock) {
      const int end = std::min(image.width, column + kBlock);
      int count = 0;
      for (int k = column; k < end; ++k) count += ((labels[k] == 0) & (w[k] > 0.0f)) ? 1 : 0;
      *counts++ += count;
    }
  }
  open_.assign(counts_.size(), 0);
  bool any = false;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      if (counts_[static_cast<std::size_t>(row) * pitch + static_cast<std::size_t>(column)] < kEnoughOfBlock) continue;
      any = true;
      for (int i = std::max(0, row - 1); i <= std::min(rows - 1, row + 1); ++i)
        for (int j = std::max(0, column - 1); j <= std::min(columns - 1, column + 1); ++j)
          open_[static_cast<std::size_t>(i) * pitch + static_cast<std::size_t>(j)] = 1;
    }
  return any;
}

bool OpenBlocks::hideRest(InverseDepthImage& image, RegionMap& map) {
  const bool any = mark(image, map);
  if (any) {
    all_w_.resize(image.w.size());
    image.w.swap(all_w_);
    std::fill(image.w.begin(), image.w.end(), 0.0f);
    const int columns = (image.width + kBlock - 1) / kBlock;
    for (int row = 0; row < image.height; ++row) {
      const std::uint8_t* is_open =
          open_.data() + static_cast<std::size_t>(row / kBlock) * static_cast<std::size_t>(columns);
      const std::size_t first = image.index(row, 0);
      for (int block = 0; block < columns; ++block) {
        if (is_open[block] == 0) continue;
        const std::size_t begin = first + static_cast<std::size_t>(block * kBlock);
        const std::size_t end = std::min(begin + kBlock, first + static_cast<std::size_t>(image.width));
        for (std::size_t i = begin; i < end; ++i) image.w[i] = map.labels[i] == 0 ? all_w_[i] : 0.0f;
      }
    }
  }
  for (std::int32_t& label : map.labels) label = std::max(label, 0);
  return any;
}

void OpenBlocks::showAll(InverseDepthImage& image) {
  image.w.swap(all_w_);
}

}  // namespace epcc
