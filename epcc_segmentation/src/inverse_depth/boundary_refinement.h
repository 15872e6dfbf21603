// SPDX-License-Identifier: BSD-3-Clause
// S5: pixels along the borders of regions find the plane that explains them best.
#pragma once

#include "epcc_segmentation/parameters.h"
#include "inverse_depth/region_map.h"

namespace epcc {

/// Refines the labels with the planes of the regions' present moments; the moments are not updated.
void refineBoundaries(const InverseDepthImage& image, const InverseDepthParameters& parameters, RegionMap& map);

}  // namespace epcc
