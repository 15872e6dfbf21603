// SPDX-License-Identifier: BSD-3-Clause
// S5: pixels along the borders of regions find the plane that explains them best.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "epcc_segmentation/parameters.h"
#include "inverse_depth/region_map.h"

namespace epcc {

/// Lists as long as the borders, kept from frame to frame.
struct RefinementMemory {
  struct Change {
    std::size_t pixel;
    std::int32_t label;
  };
  std::vector<std::size_t> frontier;  ///< pixels to look at in the next pass
  std::vector<std::uint8_t> queued;   ///< per pixel: already in the frontier
  std::vector<Change> changes;        ///< of a pass
};

/// Refines the labels with the planes of the regions' present moments; the moments are not updated.
void refineBoundaries(const InverseDepthImage& image, const InverseDepthParameters& parameters, RegionMap& map,
                      RefinementMemory& memory);

}  // namespace epcc
