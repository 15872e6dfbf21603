// SPDX-License-Identifier: BSD-3-Clause
// Surfaces and edges as JSON.
#include "datasets/files/polygon_list.h"

#include "datasets/files/vector_json.h"
#include "datasets/support/atomic_file.h"

namespace epcc {

namespace {

nlohmann::json ringJson(const SurfaceRing& ring) {
  nlohmann::json points = nlohmann::json::array(), flat = nlohmann::json::array();
  for (const Vector3& p : ring.points) points.push_back(vectorJson(p));
  for (const Vector2& p : ring.flat) flat.push_back(vectorJson(p));
  return {{"points", points}, {"flat", flat}};
}

nlohmann::json pieceJson(const SurfacePiece& piece) {
  nlohmann::json holes = nlohmann::json::array();
  for (const SurfaceRing& hole : piece.holes) holes.push_back(ringJson(hole));
  return {{"outline", ringJson(piece.outline)}, {"holes", holes}};
}

nlohmann::json surfaceJson(const SurfacePolygon& surface) {
  nlohmann::json pieces = nlohmann::json::array();
  for (const SurfacePiece& piece : surface.pieces) pieces.push_back(pieceJson(piece));
  return {{"id", surface.label},
          {"basis",
           {{"origin", vectorJson(surface.basis.origin)},
            {"across", vectorJson(surface.basis.across)},
            {"up", vectorJson(surface.basis.up)},
            {"normal", vectorJson(surface.basis.normal)}}},
          {"area", surface.area},
          {"pixel_area", surface.pixel_area},
          {"perimeter", surface.perimeter},
          {"extent",
           {{"center", vectorJson(surface.extent.center)},
            {"long_axis", vectorJson(surface.extent.long_axis)},
            {"short_axis", vectorJson(surface.extent.short_axis)},
            {"length", surface.extent.length},
            {"width", surface.extent.width}}},
          {"mended", surface.is_mended},
          {"pieces", pieces}};
}

nlohmann::json edgeJson(const PlaneEdge& edge) {
  return {{"planes", {edge.first, edge.second}},
          {"start", vectorJson(edge.start)},
          {"end", vectorJson(edge.end)},
          {"length", edge.length},
          {"angle", edge.angle},
          {"convex", edge.convex},
          {"pixels", edge.pixels},
          {"offset", edge.offset}};
}

}  // namespace

nlohmann::json polygonListJson(const SurfacePolygons& polygons) {
  nlohmann::json surfaces = nlohmann::json::array(), edges = nlohmann::json::array();
  for (const SurfacePolygon& surface : polygons.surfaces) surfaces.push_back(surfaceJson(surface));
  for (const PlaneEdge& edge : polygons.edges) edges.push_back(edgeJson(edge));
  return {{"version", 1}, {"unit", "m"}, {"surfaces", surfaces}, {"edges", edges}};
}

void writePolygonList(const std::string& path, const SurfacePolygons& polygons) {
  writeTextFile(path, polygonListJson(polygons).dump() + "\n");
}

}  // namespace epcc
