// SPDX-License-Identifier: BSD-3-Clause
// How far the planes found are from the true ones, where the frame carries them.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <vector>

#include "epcc_segmentation/plane_segmentation.h"
#include "eval/measures/overlap_table.h"

namespace epcc {

/// Coefficients (a, b, c, d) with unit normal by label id.
using TruePlanes = std::map<std::int32_t, Eigen::Vector4d>;

/// The entries of a camera file's list "planes" that have an "id" from 1 to 65534 and four "coefficients"; everything
/// else, also a "planes" that is no list, is passed over.
TruePlanes truePlanes(const nlohmann::json& camera_extra);

/// A surface against the largest of the clusters it dominates.
struct PlaneError {
  std::int32_t surface_id = 0;
  std::int32_t cluster_id = 0;
  double normal_degrees = 0.0;  ///< angle between the planes, [0, 90]
  double offset_metres = 0.0;   ///< difference of their distances from the sensor's origin
};

/// One entry for every surface that has true coefficients and dominates a cluster with a plane, by surface.
std::vector<PlaneError> planeErrors(const OverlapTable& table, const TruePlanes& truth,
                                    const std::vector<Plane>& planes);

/// Counts of one frame or, added up, of many; in whole millionths, so that they do not depend on the order.
struct PlaneErrorSums {
  long planes = 0;
  long microdegrees = 0;
  long micrometres = 0;

  /// Means over the planes; NaN where there are none.
  double meanNormalDegrees() const;
  double meanOffsetMetres() const;

  PlaneErrorSums& operator+=(const PlaneErrorSums& other);
};

PlaneErrorSums sumPlaneErrors(const std::vector<PlaneError>& errors);

}  // namespace epcc
