// SPDX-License-Identifier: BSD-3-Clause
// The only file of the programs that knows whether polygons and meshes can be made.
#include "eval/segment/frame_surfaces.h"

#include <new>

namespace epcc {

#ifdef EPCC_WITH_GEOS
std::string surfacesMissing() {
  return {};
}

FrameSurfaces frameSurfaces(const DepthFrame& frame, const SensorModel& sensor, const PlaneSegmentation& result,
                            bool with_mesh) {
  FrameSurfaces surfaces;
  surfaces.polygons = surfacePolygons(frame, sensor, result);
  if (with_mesh) surfaces.mesh = surfaceMesh(surfaces.polygons.surfaces);
  if (surfaces.mesh.status == Status::OutOfMemory) throw std::bad_alloc();
  return surfaces;
}
#else
std::string surfacesMissing() {
  return "this program was built without GEOS (EPCC_WITH_GEOS)";
}

FrameSurfaces frameSurfaces(const DepthFrame& /*frame*/, const SensorModel& /*sensor*/,
                            const PlaneSegmentation& /*result*/, bool /*with_mesh*/) {
  FrameSurfaces surfaces;
  surfaces.polygons.status = Status::Failed;
  surfaces.polygons.problem = surfacesMissing();
  return surfaces;
}
#endif

}  // namespace epcc
