// SPDX-License-Identifier: BSD-3-Clause
// The versioned JSON list of a frame's surfaces as polygons, and of their edges.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "epcc_segmentation/surface_polygon.h"

namespace epcc {

/// Version 1, explained in docs/reference/formats.md: {version, unit, surfaces: [{id, basis, area, ..., pieces:
/// [{outline: {points, flat}, holes}]}], edges: [{planes, start, end, ...}]}; metres and radians.
nlohmann::json polygonListJson(const SurfacePolygons& polygons);
/// Throws OutputError.
void writePolygonList(const std::string& path, const SurfacePolygons& polygons);

}  // namespace epcc
