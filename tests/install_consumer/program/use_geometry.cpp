// SPDX-License-Identifier: BSD-3-Clause
// Polygons and a mesh of a wall and a floor, which meet in an edge.
#include <epcc_segmentation/plane_edges.h>
#include <epcc_segmentation/plane_extractor.h>
#include <epcc_segmentation/surface_mesh.h>
#include <epcc_segmentation/surface_polygon.h>
#include <epcc_segmentation/surface_sampling.h>

#include <cmath>
#include <cstdio>

#include "wall_and_floor.h"

int main() {
  const WallAndFloor room;
  const epcc::DepthFrame frame = room.frame();
  epcc::PlaneExtractor extractor;
  epcc::PlaneSegmentation result;
  if (!extractor.extract(frame, result)) return 1;
  const epcc::SurfacePolygons polygons = epcc::surfacePolygons(frame, extractor.sensor(), result);
  const epcc::SurfaceMesh mesh = epcc::surfaceMesh(polygons.surfaces);
  std::printf("%zu surfaces, %zu edges, %zu triangles %s\n", polygons.surfaces.size(), polygons.edges.size(),
              mesh.triangles.size(), polygons.problem.c_str());
  if (polygons.surfaces.size() != 2 || polygons.edges.size() != 1 || polygons.edges[0].convex) return 2;
  // The library's numbers are read as it wrote them, whatever flags this is built with.
  const epcc::PlaneEdge& edge = polygons.edges[0];
  if (std::abs(edge.start.y() - 0.6) > 0.01 || std::abs(edge.end.z() - 2.0) > 0.01) return 3;
  if (std::abs(edge.length - 2.0 * room.camera.width / room.camera.fx) > 0.05) return 4;
  double area = 0.0;
  for (const epcc::SurfacePolygon& surface : polygons.surfaces) area += surface.area;
  if (std::abs(mesh.totalArea() - area) > 1e-6 * area) return 5;
  return epcc::sampleSurface(polygons.surfaces[0], 0.1).empty() ? 6 : 0;
}
