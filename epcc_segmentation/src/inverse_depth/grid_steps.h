// SPDX-License-Identifier: BSD-3-Clause
// How many pixels lie between the samples of a grid.
#pragma once

#include <cmath>

namespace epcc {

/// Pixels from a sample to the next one along a row and along a column, each stands for the block around it. They
/// differ where a frame measures few of its rows, or few of its columns.
struct GridSteps {
  int across = 1;
  int along = 1;

  GridSteps() = default;
  GridSteps(int stride) : across(stride), along(stride) {}  // NOLINT(google-explicit-constructor): one both ways
  GridSteps(int in_row, int in_column) : across(in_row), along(in_column) {}

  int area() const { return across * along; }
  /// Of a square of the same area.
  double side() const { return across == along ? across : std::sqrt(static_cast<double>(area())); }
  bool isEveryPixel() const { return area() == 1; }
};

inline bool operator==(const GridSteps& a, const GridSteps& b) {
  return a.across == b.across && a.along == b.along;
}

}  // namespace epcc
