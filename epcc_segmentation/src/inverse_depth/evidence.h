// SPDX-License-Identifier: BSD-3-Clause
// S7: regions that are too small, too rough, too poorly supported or bent are no planes.
#pragma once

#include <cstdint>
#include <vector>

#include "epcc_segmentation/parameters.h"
#include "epcc_segmentation/sensor_model.h"
#include "inverse_depth/region_map.h"
#include "inverse_depth/surface_bending.h"

namespace epcc {

/// True if the region counts as a plane.
bool isPlane(const PlaneMoments& region, const InverseDepthParameters& parameters, const SensorModel& sensor);

/// Lists of the regions, kept from frame to frame.
struct EvidenceMemory {
  std::vector<std::uint8_t> is_plane, may_bend;
  std::vector<std::int32_t> new_label;  ///< per label
  BendingMemory bending;
};

/// Unlabels the pixels of the regions that do not, and of those that are facets of a curved surface: a quadric explains
/// most of their residual, and bends tightly.
void rejectRegions(const InverseDepthImage& image, const InverseDepthParameters& parameters, const SensorModel& sensor,
                   RegionMap& map, EvidenceMemory& memory, int threads = 1);

}  // namespace epcc
