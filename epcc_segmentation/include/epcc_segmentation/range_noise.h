// SPDX-License-Identifier: BSD-3-Clause
// The error of a laser range finder, measured on its scans.
#pragma once

#include <cstddef>
#include <vector>

#include "epcc_segmentation/export.h"
#include "epcc_segmentation/laser_scan.h"
#include "epcc_segmentation/sensor_model.h"

namespace epcc {

/// sigma_r(r) = a + b r as scans show it.
struct RangeNoiseEstimate {
  double a = 0.01;          ///< metres
  double b = 0.0;           ///< metres a metre
  std::size_t windows = 0;  ///< straight windows that it comes from; 0: nothing was measured, the values are generic

  /// For LaserLineExtractor.
  SensorModel model() const { return SensorModel::polynomial(0.0, b, a); }
};

/// Fits lines to short windows of consecutive beams and reads the error off their residuals: in each range of distances
/// a low quantile of them, for corners, jumps and clutter only enlarge residuals, corrected for what a low quantile is
/// of noise alone. a and b, neither below zero, are fitted to these.
EPCC_CORE_EXPORT RangeNoiseEstimate estimateRangeNoise(const std::vector<LaserScan>& scans);

}  // namespace epcc
