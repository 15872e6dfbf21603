// SPDX-License-Identifier: BSD-3-Clause
// The borders of a label image along the pixels' edges, cut into arcs that two neighbours share.
#pragma once

#include <cstdint>
#include <vector>

namespace epcc {

/// A walk along pixel edges from corner to corner. Between its ends it has the same label on either side all along.
struct LabelArc {
  std::vector<int> corners;          ///< the first and the last are the same if nothing else meets the arc
  std::int32_t left = 0, right = 0;  ///< labels to the left and right of the walk as seen on the picture, 0 none
};

/// A closed walk round a region or one of its holes: the region is to its left, as seen on the picture.
struct LabelRing {
  struct Part {
    int arc;
    bool is_reversed;
  };
  std::vector<Part> parts;
  std::int32_t label = 0;
  int component = 0;  ///< rings of one connected part of a region have the same, from 0
  int pixels = 0;     ///< inside the ring on the picture; 0 of one that goes round the whole of a scan
};

/// Arcs and rings of all labels from 1. Regions connect to their 4 neighbours: pixels that touch at a corner are two
/// parts. No ring passes a corner twice. The order depends on the labels alone.
struct LabelArcs {
  int columns = 0;  ///< corners of a row; corner = row * columns + column, up and left of the pixel (row, column)
  std::vector<LabelArc> arcs;
  std::vector<LabelRing> rings;

  int row(int corner) const { return corner / columns; }
  int column(int corner) const { return corner % columns; }
};

/// One pass over the image and one over the borders. Of a scan that closes round, the first column is the last one's
/// neighbour.
LabelArcs findLabelArcs(const std::vector<std::int32_t>& labels, int width, int height, bool closes_round);

}  // namespace epcc
