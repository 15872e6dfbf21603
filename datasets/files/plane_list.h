// SPDX-License-Identifier: BSD-3-Clause
// The versioned JSON list of a frame's planes.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "epcc_segmentation/depth_frame.h"
#include "epcc_segmentation/plane_segmentation.h"

namespace epcc {

/// Version 1: {version, width, height, frame, planes: [{id, coefficients [a, b, c, d], coefficients_covariance 4x4,
/// pixel_count, rms, centroid, contour: {outer: [[[column, row], ...], ...], holes: [...]}}]}; metres, pixels.
nlohmann::json planeListJson(const PlaneSegmentation& segmentation, Projection projection = Projection::Perspective);
void writePlaneList(const std::string& path, const PlaneSegmentation& segmentation,
                    Projection projection = Projection::Perspective);

}  // namespace epcc
