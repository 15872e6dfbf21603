// SPDX-License-Identifier: BSD-3-Clause
// The planes as polygons with holes, the edges where they meet, and a triangle mesh that is closed there.
#include <epcc_segmentation/plane_extractor.h>
#include <epcc_segmentation/surface_mesh.h>
#include <epcc_segmentation/surface_polygon.h>
#include <epcc_segmentation/surface_sampling.h>

#include <cstdio>

#include "room.h"

int main() {
  const epcc::PinholeCamera camera = example::camera();
  std::vector<float> depth = example::depthOfRoom();
  for (int row = 40; row < 60; ++row)  // a picture on the wall that the sensor does not see
    for (int column = 60; column < 100; ++column) depth[static_cast<std::size_t>(row * 320 + column)] = 0.0f;
  const epcc::DepthFrame frame = epcc::DepthFrame::fromDepth(depth.data(), camera);

  epcc::PlaneExtractor extractor;
  epcc::PlaneSegmentation result;
  if (!extractor.extract(frame, result)) return 1;

  // The sensor says how far a border may be simplified, and when two planes meet.
  const epcc::SurfacePolygons polygons = epcc::surfacePolygons(frame, extractor.sensor(), result);
  if (polygons.status != epcc::Status::Ok) return 1;
  for (const epcc::SurfacePolygon& surface : polygons.surfaces) {
    std::printf("plane %d: %.1f square metres, %.1f m by %.1f m\n", surface.label, surface.area, surface.extent.length,
                surface.extent.width);
    for (const epcc::SurfacePiece& piece : surface.pieces)
      for (const epcc::SurfaceRing& hole : piece.holes)
        if (hole.signedArea() < -0.01) std::printf("  with a hole of %.2f square metres\n", -hole.signedArea());
  }
  for (const epcc::PlaneEdge& edge : polygons.edges)
    if (edge.length > 0.5)
      std::printf("planes %d and %d meet in %s, %.1f m long, %.0f degrees\n", edge.first, edge.second,
                  edge.convex ? "an edge" : "a corner", edge.length, 57.29578 * edge.angle);

  const epcc::SurfaceMesh mesh = epcc::surfaceMesh(polygons.surfaces);
  std::printf("mesh: %.1f square metres\n", mesh.totalArea());

  // The floor, a point every 10 cm.
  const std::vector<epcc::Vector3> points = epcc::sampleSurface(polygons.surfaces[1], 0.1);
  std::printf("%s\n", points.empty() ? "no points" : "points every 10 cm");
}

// Prints:
//   plane 1: 10.7 square metres, 3.9 m by 2.8 m
//     with a hole of 0.18 square metres
//   plane 2: 4.5 square metres, 3.9 m by 1.3 m
//   plane 3: 2.8 square metres, 2.8 m by 1.2 m
//   planes 1 and 2 meet in a corner, 3.9 m long, 90 degrees
//   planes 1 and 3 meet in a corner, 2.2 m long, 90 degrees
//   planes 2 and 3 meet in a corner, 1.1 m long, 90 degrees
//   mesh: 18.0 square metres
//   points every 10 cm
