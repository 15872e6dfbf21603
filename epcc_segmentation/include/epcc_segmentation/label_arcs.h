// SPDX-License-Identifier: BSD-3-Clause
// The borders of a label image along the pixels' edges, cut into arcs that two neighbours share.
#pragma once

#include <cstdint>
#include <vector>

#include "epcc_segmentation/export.h"

namespace epcc {

/// A walk along pixel edges from corner to corner. Between its ends it has the same label on either side all along.
struct LabelArc {
  std::vector<int> corners;  ///< the first and the last are the same if nothing else meets the arc
  std::int32_t left = 0;     ///< label to the left of the walk as seen on the picture, 0 none
  std::int32_t right = 0;    ///< label to the right of the walk as seen on the picture, 0 none
};

/// A closed walk round a region or one of its holes: the region is to its left, as seen on the picture.
struct LabelRing {
  /// An arc, walked from one of its ends to the other.
  struct Part {
    int arc = 0;               ///< in LabelArcs::arcs
    bool is_reversed = false;  ///< walked from the last corner to the first
  };
  std::vector<Part> parts;  ///< in the order of the walk
  std::int32_t label = 0;   ///< of the region
  int component = 0;        ///< rings of one connected part of a region have the same, from 0
  int pixels = 0;           ///< inside the ring on the picture; 0 of one that goes round the whole of a scan
};

/// Arcs and rings of all labels from 1. Regions connect to their 4 neighbours: pixels that touch at a corner are two
/// parts. No ring passes a corner twice. The order depends on the labels alone.
struct LabelArcs {
  int columns = 0;  ///< corners of a row; corner = row * columns + column, up and left of the pixel (row, column)
  std::vector<LabelArc> arcs;    ///< of all regions, each once
  std::vector<LabelRing> rings;  ///< of all regions; of those of a component the outline has the most pixels

  /// Of a corner; row 0 is the upper edge of the image.
  int row(int corner) const { return corner / columns; }
  /// Of a corner; column 0 is the left edge of the image.
  int column(int corner) const { return corner % columns; }
  /// The corners of a ring in the order of its walk, each once.
  EPCC_CORE_EXPORT std::vector<int> corners(const LabelRing& ring) const;
};

/// One pass over the image and one over the borders. Of a scan that closes round, the first column is the last one's
/// neighbour. `labels` is row-major, width * height values; the result is empty if they are not so many, or more than
/// 2^28 - 1.
///
/// This is how regions are walked around whose area counts, those of polygons and of maps: two neighbours have the same
/// line, and what is inside is the pixels. traceContours() walks through the pixels' centres instead, as contours are
/// defined (Suzuki and Abe): with 8 neighbours, there and back along a line of pixels, whose inside is nothing, and
/// with a gap between neighbours. Neither can be had of the other.
EPCC_CORE_EXPORT LabelArcs findLabelArcs(const std::vector<std::int32_t>& labels, int width, int height,
                                         bool closes_round);

}  // namespace epcc
