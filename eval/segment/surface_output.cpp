// SPDX-License-Identifier: BSD-3-Clause
// Surfaces are found once for both files.
#include "eval/segment/surface_output.h"

#include "datasets/files/mesh_file.h"
#include "datasets/files/polygon_list.h"
#include "datasets/support/input_error.h"
#include "eval/pictures/label_colors.h"
#include "eval/segment/frame_surfaces.h"

namespace epcc {

void writeSurfaces(const OutputPaths& paths, const DepthFrame& frame, const PlaneSegmentation& result,
                   const SurfaceStyle& style) {
  if (paths.mesh.empty() && paths.polygons.empty()) return;
  const FrameSurfaces surfaces = frameSurfaces(frame, style.sensor, result, !paths.mesh.empty());
  const SurfacePolygons& polygons = surfaces.polygons;
  if (polygons.status != Status::Ok)
    throw OutputError(paths.mesh.empty() ? paths.polygons : paths.mesh, "surfaces", polygons.problem);
  if (!paths.polygons.empty()) writePolygonList(paths.polygons, polygons);
  if (paths.mesh.empty()) return;
  std::vector<Rgb> colors;
  for (const SurfacePolygon& surface : polygons.surfaces) colors.push_back(labelColor(surface.label));
  writeMesh(paths.mesh, surfaces.mesh, colors, style.mesh_is_text ? MeshEncoding::Text : MeshEncoding::Binary);
}

}  // namespace epcc
