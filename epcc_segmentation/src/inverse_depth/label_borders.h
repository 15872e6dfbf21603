// SPDX-License-Identifier: BSD-3-Clause
// Where labels change along rows and columns, as bits: what follows a border visits its pixels alone.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace epcc {

/// One bit per pixel of a row, 64 to a word; bits beyond the row are 0.
using RowBits = std::vector<std::uint64_t>;

/// What a row of labels looks like.
struct RowBorders {
  RowBits left;      ///< the label is not that of the pixel to the left; 0 in the first column
  RowBits above;     ///< the label is not that of the pixel above; 0 in the first row
  RowBits labelled;  ///< the label is not 0

  void resize(int width);
};

/// Marks the borders of row `row` of a row-major image of labels.
void markBorders(const std::int32_t* labels, int width, int row, RowBorders& borders);

/// The bits to the left alone.
void markLeftBorders(const std::int32_t* labels, int width, int row, RowBits& left);

/// The place of the lowest bit of a word that is not 0.
inline int lowestBit(std::uint64_t word) {
  return __builtin_ctzll(word);
}

/// Calls visit(place) for each bit of a word, the lowest first; `place` is that of the word's first bit.
template <typename Visit>
inline void forEachBit(std::uint64_t word, int place, const Visit& visit) {
  for (; word != 0; word &= word - 1) visit(place + lowestBit(word));
}

}  // namespace epcc
