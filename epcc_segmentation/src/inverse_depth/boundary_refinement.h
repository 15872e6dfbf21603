// SPDX-License-Identifier: BSD-3-Clause
// S5: pixels along the borders of regions find the plane that explains them best.
#pragma once

#include <cstdint>
#include <vector>

#include "epcc_segmentation/parameters.h"
#include "inverse_depth/crease_votes.h"
#include "inverse_depth/label_borders.h"
#include "inverse_depth/region_map.h"

namespace epcc {

/// What the refinement knows of a region.
struct RefinedPlane {
  double x = 0.0, y = 0.0, z = 0.0;  ///< q
  double inverse_slope = 1e300;       ///< 1 / sqrt(slope factor); huge where there is no plane: all are far from it
};

/// Lists as long as the borders, kept from frame to frame.
struct RefinementMemory {
  struct Pixel {
    std::int32_t row, column;
  };
  struct Change {
    Pixel pixel;
    std::int32_t label;
  };
  std::vector<RefinedPlane> planes;  ///< per label
  std::vector<Pixel> frontier;       ///< to look at in the next pass
  std::vector<std::uint8_t> queued;  ///< per pixel: already in the frontier; 0 between passes
  std::vector<Change> changes;       ///< of a pass
  RowBorders borders, upper;         ///< of a row and of the one above
  RowBits frontier_bits, upper_frontier;
  PixelList list;
  CreaseVotes creases;
};

/// Refines the labels with the planes of the regions' present moments; the moments are not updated.
void refineBoundaries(const InverseDepthImage& image, const InverseDepthParameters& parameters, RegionMap& map,
                      RefinementMemory& memory);

}  // namespace epcc
