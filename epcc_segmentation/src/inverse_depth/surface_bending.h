// SPDX-License-Identifier: BSD-3-Clause
// How a region bends: the quadric that fits better than its plane.
#pragma once

#include <cstdint>
#include <vector>

#include "inverse_depth/label_borders.h"
#include "inverse_depth/region_map.h"
#include "inverse_depth/region_view.h"

namespace epcc {

/// What measureBending() finds, and its lists, kept from frame to frame.
struct BendingMemory {
  std::vector<Bending> bending;  ///< per region

  std::vector<std::int32_t> view_of;  ///< per label, -1 none
  /// A band of rows.
  struct Band {
    std::vector<RegionView> views;
    RowBits left;
    PixelList begins;  ///< of the runs on a row, but the first
  };
  std::vector<Band> bands;
};

/// Measures the regions k with wanted[k] != 0; the others stay zero. One pass over the pixels.
void measureBending(const InverseDepthImage& image, const RegionMap& map, const std::vector<std::uint8_t>& wanted,
                    BendingMemory& memory, int threads = 1);

}  // namespace epcc
