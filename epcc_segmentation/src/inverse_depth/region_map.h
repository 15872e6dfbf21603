// SPDX-License-Identifier: BSD-3-Clause
// Labelled regions with their moments, the state that steps S3 to S8 work on.
#pragma once

#include <cstdint>
#include <vector>

#include "inverse_depth/inverse_depth_image.h"
#include "inverse_depth/plane_moments.h"
#include "inverse_depth/row_sums.h"

namespace epcc {

/// Labels are row-major, 0 = none; regions[k - 1] belongs to label k, n = 0 marks a dropped region.
struct RegionMap {
  std::vector<std::int32_t> labels;
  std::vector<PlaneMoments> regions;
  std::vector<RaySums> sums;  ///< memory of accumulate()

  /// Recomputes every region's moments from the labels.
  void accumulate(const InverseDepthImage& image);
  /// Gives every pixel of label k the label new_label[k]; regions are left as they are.
  void relabel(const std::vector<std::int32_t>& new_label);
};

}  // namespace epcc
