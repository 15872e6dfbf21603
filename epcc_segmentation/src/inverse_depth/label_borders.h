// SPDX-License-Identifier: BSD-3-Clause
// Where labels change along rows and columns, as bits: what follows a border visits its pixels alone.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace epcc {

/// One bit per pixel of a row, 64 to a word; bits beyond the row are 0.
using RowBits = std::vector<std::uint64_t>;

inline std::size_t wordsOf(int width) {
  return (static_cast<std::size_t>(width) + 63) / 64;
}

/// Bits of row `row` of a row-major image of labels: the label is not that of the pixel to the left; 0 in the first
/// column.
void markLeftBorders(const std::int32_t* labels, int width, int height, int row, RowBits& bits);
/// The label is not that of the pixel above; 0 in the first row.
void markUpperBorders(const std::int32_t* labels, int width, int row, RowBits& bits);
/// The label is not 0.
void markLabelled(const std::int32_t* labels, int width, int row, RowBits& bits);

/// What a row of labels looks like.
struct RowBorders {
  RowBits left, above, labelled;

  void resize(int width) {
    for (RowBits* bits : {&left, &above, &labelled}) bits->assign(wordsOf(width), 0);
  }
  void mark(const std::int32_t* labels, int width, int height, int row) {
    markLeftBorders(labels, width, height, row, left);
    markUpperBorders(labels, width, row, above);
    markLabelled(labels, width, row, labelled);
  }
};

/// A word of bits, but of the pixels one to the left of its own.
inline std::uint64_t fromLeft(const RowBits& bits, std::size_t word) {
  return bits[word] << 1 | (word > 0 ? bits[word - 1] >> 63 : 0);
}
/// One to the right.
inline std::uint64_t fromRight(const RowBits& bits, std::size_t word) {
  return bits[word] >> 1 | (word + 1 < bits.size() ? bits[word + 1] << 63 : 0);
}

/// A list of the pixels of a row whose bits are set. Borders are everywhere and nowhere: they are listed two at a time
/// without asking for the end each time, and then visited in one loop.
class PixelList {
 public:
  /// For rows of this width.
  void clear(int width) {
    columns_.resize(64 * wordsOf(width) + kStep);
    end_ = columns_.data();
  }
  /// Words in any order, each once.
  void add(std::uint64_t word_bits, std::size_t word) {
    const int place = static_cast<int>(64 * word);
    while (word_bits != 0)
      for (int k = 0; k < kStep; ++k) {
        *end_ = place + __builtin_ctzll(word_bits | std::uint64_t{1} << 63);
        end_ += word_bits != 0 ? 1 : 0;
        word_bits &= word_bits - 1;
      }
  }
  const int* begin() const { return columns_.data(); }
  const int* end() const { return end_; }

 private:
  static constexpr int kStep = 2;
  std::vector<int> columns_;
  int* end_ = nullptr;
};

}  // namespace epcc
