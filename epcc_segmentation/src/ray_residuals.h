// SPDX-License-Identifier: BSD-3-Clause
// Sums over the rays of each label and over what the samples on them are off its plane, row by row, in vector lanes.
#pragma once

#include <cstdint>

#include "label_sums.h"
#include "sensor_variance.h"

namespace epcc {

/// A plane as the inverse depth of its points: w = theta . ray, with rays (u, v, 1), for a spherical scan of unit
/// length and w the inverse range. theta = -normal / d.
struct RayPlane {
  double theta[3] = {0.0, 0.0, 0.0};
};

/// With the weight W = 1 / sigma_w^2 at the plane's own inverse depth w, and rho = w (1 - w z), the inverse depth by
/// which a sample z lies in front: W xx, W xy, W xz, W yy, W yz, W zz of the rays, W x rho, W y rho, W z rho, W rho
/// rho, and the number of samples that count.
constexpr int kResidualSums = 11;

/// Sums of a label; all 0 before the first row.
struct ResidualSums {
  double lanes[kResidualSums][kSumLanes];
};

/// Adds a row to sums[0 .. label_count) of the labels 1 .. label_count. A sample at less than half or more than twice
/// the plane's distance does not count, nor does one whose ray does not meet the plane.
/// row.weight and row.measured are not asked for.
void addToResidualSums(const SampleRow& row, const SensorVariance& variance, std::int32_t label_count,
                       const RayPlane* planes, ResidualSums* sums);

}  // namespace epcc
