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
/// Of a cloud with a frame of its own (`geometry`, null of others) also where its sensor is: sensor {kind, pose 3x4}.
nlohmann::json planeListJson(const PlaneSegmentation& segmentation, Projection projection = Projection::Perspective,
                             const CloudGeometry* geometry = nullptr);
void writePlaneList(const std::string& path, const PlaneSegmentation& segmentation,
                    Projection projection = Projection::Perspective, const CloudGeometry* geometry = nullptr);

}  // namespace epcc
