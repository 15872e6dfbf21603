// SPDX-License-Identifier: BSD-3-Clause
// What holds for every segmentation.
#pragma once

#include <string>

#include "epcc_segmentation/depth_frame.h"
#include "epcc_segmentation/plane_segmentation.h"

namespace epcc::fuzz {

/// A plane that was found: finite, a unit normal towards the sensor at `sensor`, covariances finite, symmetric and of
/// no negative variance.
void checkPlane(const Plane& plane, const Eigen::Vector3d& sensor);

/// Of a frame that could be used: labels on its valid pixels alone and as many as the planes say, planes in order.
void checkSegmentation(const DepthFrame& frame, const PlaneSegmentation& result);

/// Of a frame that could not: no planes, no labels, and words that say why.
void checkFailure(Status status, const std::string& error, const PlaneSegmentation& result);

/// Both are the same, to the bit.
void checkSame(const PlaneSegmentation& one, const PlaneSegmentation& other);

}  // namespace epcc::fuzz
