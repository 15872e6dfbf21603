// SPDX-License-Identifier: BSD-3-Clause
// Frames and label images made into the state that the steps of the inverse-depth mode work on.
#pragma once

#include <vector>

#include "inverse_depth/inverse_depth_image.h"
#include "inverse_depth/region_map.h"
#include "tests/support/rendered_room.h"

namespace epcc::test {

inline const SensorModel kWhite = SensorModel::axial(0.002, 0.0, 0.1);

inline InverseDepthImage imageOf(const RenderedRoom& room, const SensorModel& sensor = kWhite) {
  InverseDepthImage image;
  image.read(room.frame());
  image.weigh(sensor);
  return image;
}

inline RegionMap regionsOf(const InverseDepthImage& image, const std::vector<std::int32_t>& labels, int count) {
  RegionMap map;
  map.labels = labels;
  map.regions.resize(static_cast<std::size_t>(count));
  map.accumulate(image);
  return map;
}

}  // namespace epcc::test
