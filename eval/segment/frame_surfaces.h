// SPDX-License-Identifier: BSD-3-Clause
// The surfaces of a segmented frame, as epcc_segment writes and epcc_view shows them; a build may have none.
#pragma once

#include <string>

#include "epcc_segmentation/depth_frame.h"
#include "epcc_segmentation/plane_segmentation.h"
#include "epcc_segmentation/sensor_model.h"
#include "epcc_segmentation/surface_mesh.h"
#include "epcc_segmentation/surface_polygon.h"

namespace epcc {

/// Why this build has no polygons and meshes, in words; empty if it has them.
std::string surfacesMissing();

/// Polygons, and the mesh of the same points.
struct FrameSurfaces {
  SurfacePolygons polygons;  ///< its `problem` says why there are none
  SurfaceMesh mesh;
};

/// Surfaces of the planes that were found in the frame with this sensor model (PlaneExtractor::sensor()). Without
/// `with_mesh` there are no triangles.
FrameSurfaces frameSurfaces(const DepthFrame& frame, const SensorModel& sensor, const PlaneSegmentation& result,
                            bool with_mesh);

}  // namespace epcc
