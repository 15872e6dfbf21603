// SPDX-License-Identifier: BSD-3-Clause
// Triangle meshes of the polygons of surfaces.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "epcc_segmentation/export.h"
#include "epcc_segmentation/status.h"
#include "epcc_segmentation/surface_polygon.h"
#include "epcc_segmentation/vectors.h"

namespace epcc {

/// Triangles of several surfaces. Surfaces that meet at an edge share the vertices there.
struct SurfaceMesh {
  std::vector<Vector3> vertices;              ///< metres, in the frame of the cloud
  std::vector<std::array<int, 3>> triangles;  ///< vertices, counter-clockwise for the sensor
  std::vector<int> labels;                    ///< of each triangle: it is on planes[label - 1]
  Status status = Status::Ok;                 ///< OutOfMemory: there are no triangles for that alone

  /// Of a triangle, square metres.
  EPCC_CORE_EXPORT double area(std::size_t triangle) const;
  /// Of all triangles of a label; 0: of all.
  EPCC_CORE_EXPORT double totalArea(int label = 0) const;
};

/// The constrained Delaunay triangulation of each surface: it has the polygon's points alone and covers the polygon,
/// and nothing outside of it or in its holes. Surfaces in the order given, the same result each time. Nothing is
/// thrown: if memory runs out there are none, and `status` says so.
EPCC_CORE_EXPORT SurfaceMesh surfaceMesh(const std::vector<SurfacePolygon>& surfaces);

}  // namespace epcc
