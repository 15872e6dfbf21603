// SPDX-License-Identifier: BSD-3-Clause
// S4: neighbouring regions that are one surface within the sensor's error become one.
#pragma once

#include "epcc_segmentation/parameters.h"
#include "epcc_segmentation/sensor_model.h"
#include "inverse_depth/region_map.h"

namespace epcc {

/// Merges best-first until no neighbours are alike; then drops regions with fewer than
/// min_samples independent samples. Labels and moments of `map` are updated.
void mergeRegions(const InverseDepthImage& image, const MergingParameters& parameters, const SensorModel& sensor,
                  RegionMap& map);

/// Where two regions meet.
struct Contact {
  int count = 0;                                   ///< places
  Eigen::Matrix3d rays = Eigen::Matrix3d::Zero();  ///< sum of ray ray^T / sigma^2 over them

  Contact& operator+=(const Contact& other) {
    count += other.count;
    rays += other.rays;
    return *this;
  }
};

/// Cost of a merge, <= 1 to merge: RSS increase over what offset and correlation allow.
double mergeCost(const PlaneMoments& a, const PlaneMoments& b, const Contact& contact,
                 const MergingParameters& parameters, double pixels_per_sample);

/// A weak ridge that keeps one-line regions solvable.
double weakRidge(const PlaneMoments& moments);

}  // namespace epcc
