// SPDX-License-Identifier: BSD-3-Clause
// S4: neighbouring regions that are one surface within the sensor's error become one.
#pragma once

#include "epcc_segmentation/parameters.h"
#include "epcc_segmentation/sensor_model.h"
#include "inverse_depth/region_contacts.h"

namespace epcc {

/// Merges best-first until no two regions in contact are alike, then unlabels the regions with fewer than min_samples
/// independent samples. Labels and moments of `map` are updated.
void mergeRegions(const RegionContacts& contacts, const InverseDepthParameters& parameters, const SensorModel& sensor,
                  RegionMap& map);

}  // namespace epcc
