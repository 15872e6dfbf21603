// SPDX-License-Identifier: BSD-3-Clause
// Polygons, edges and meshes of the planes of any frame, and of regions that no segmentation would give.
#include <cmath>

#include "epcc_segmentation/contours.h"
#include "epcc_segmentation/plane_extractor.h"
#include "epcc_segmentation/surface_mesh.h"
#include "epcc_segmentation/surface_polygon.h"
#include "epcc_segmentation/surface_sampling.h"
#include "tests/fuzz/fuzz_frame.h"
#include "tests/fuzz/require.h"
#include "tests/fuzz/targets.h"

namespace epcc::fuzz {
namespace {

constexpr std::size_t kMostSamples = 2000;

/// Labels by bytes where there are planes: of measured pixels alone, as many as the planes say.
void scatterLabels(const DepthFrame& frame, FuzzInput& input, PlaneSegmentation& segmentation) {
  const int planes = static_cast<int>(segmentation.planes.size());
  if (planes == 0) return;
  std::vector<std::size_t> counts(segmentation.planes.size(), 0);
  Eigen::Vector3d point;
  for (int row = 0; row < frame.height(); ++row)
    for (int column = 0; column < frame.width(); ++column) {
      std::int32_t& label = segmentation.labels[frame.index(row, column)];
      const std::uint8_t byte = input.byte();
      if (byte > 0) label = frame.point(row, column, point) ? byte % (planes + 1) : 0;
      if (label > 0) ++counts[static_cast<std::size_t>(label) - 1];
    }
  for (std::size_t k = 0; k < counts.size(); ++k) segmentation.planes[k].pixel_count = counts[k];
}

PolygonOptions takePolygonOptions(FuzzInput& input) {
  PolygonOptions options;
  options.placement = input.oneIn(4) ? OutlinePlacement::Orthogonal : OutlinePlacement::AlongRay;
  options.close_edges = !input.oneIn(4);
  if (!input.oneIn(4)) return options;
  options.min_ring_pixels = input.byte();
  for (double* number : {&options.tolerance_pixels, &options.tolerance_sigma, &options.max_area_change})
    if (input.oneIn(2)) *number = input.anyNumber();
  return options;
}

void checkRing(const SurfaceRing& ring, bool is_hole) {
  require(ring.points.size() >= 3 && ring.points.size() == ring.flat.size(), "a ring has points");
  for (const Vector3& point : ring.points) require(point.allFinite(), "a ring's points are finite");
  for (const Vector2& point : ring.flat) require(point.allFinite(), "a ring's coordinates are finite");
  require(is_hole ? ring.signedArea() <= 0.0 : ring.signedArea() >= 0.0, "a ring runs the right way round");
}

void checkSurface(const SurfacePolygon& surface, std::size_t planes) {
  require(surface.label >= 1 && static_cast<std::size_t>(surface.label) <= planes, "a surface's plane exists");
  require(std::isfinite(surface.area) && surface.area >= 0.0, "an area is one");
  require(std::isfinite(surface.perimeter) && surface.perimeter >= 0.0, "a perimeter is one");
  require(std::isfinite(surface.pixel_area) && surface.pixel_area >= 0.0, "a pixel's area is one");
  require(surface.extent.center.allFinite() && std::isfinite(surface.extent.length) &&
              surface.extent.width <= surface.extent.length,
          "an extent is one");
  for (const SurfacePiece& piece : surface.pieces) {
    checkRing(piece.outline, false);
    for (const SurfaceRing& hole : piece.holes) checkRing(hole, true);
  }
}

void checkMesh(const SurfaceMesh& mesh) {
  require(mesh.labels.size() == mesh.triangles.size(), "each triangle has its label");
  for (const Vector3& vertex : mesh.vertices) require(vertex.allFinite(), "vertices are finite");
  for (const auto& triangle : mesh.triangles)
    for (const int corner : triangle)
      require(corner >= 0 && static_cast<std::size_t>(corner) < mesh.vertices.size(), "a triangle's corners exist");
  require(std::isfinite(mesh.totalArea()), "an area is finite");
}

bool runSurfaces(const std::uint8_t* data, std::size_t size) {
  FuzzInput input(data, size);
  const PolygonOptions options = takePolygonOptions(input);
  const bool scatter = input.oneIn(2);
  const double spacing = input.oneIn(4) ? input.anyNumber() : 0.1;
  FuzzFrame values = FuzzFrame::take(input);
  const FuzzScene scene = FuzzScene::take(input);
  FuzzInput labels = input;  // the same bytes are errors and labels
  values.fill(scene, Eigen::Isometry3d::Identity(), input);
  const DepthFrame frame = values.view();
  PlaneExtractor extractor(Parameters(), SensorModel::axial(0.002, 0.001));
  PlaneSegmentation segmentation;
  if (!extractor.extract(frame, segmentation)) return false;
  if (scatter) scatterLabels(frame, labels, segmentation);

  const int height = static_cast<int>(segmentation.labels.size()) / segmentation.width;
  const auto contours =
      traceAllContours(segmentation.labels, segmentation.width, height, static_cast<int>(segmentation.planes.size()));
  require(contours.size() == segmentation.planes.size(), "each plane has its contours");
  const auto points = pointsOnPlanes(frame, segmentation, options.placement);
  require(points.size() == segmentation.labels.size(), "each pixel has its point");
  const SurfacePolygons polygons = surfacePolygons(frame, extractor.sensor(), segmentation, options);
  require((polygons.status == Status::Ok) == polygons.problem.empty(), "what is wrong is said in words");
  if (polygons.status != Status::Ok) {
    require(polygons.status != Status::Failed && polygons.surfaces.empty(), "a failure is foreseen");
    requireOneLine(polygons.problem);
    return false;
  }
  require(polygons.surfaces.size() == segmentation.planes.size(), "each plane has its surface");
  for (const SurfacePolygon& surface : polygons.surfaces) {
    checkSurface(surface, segmentation.planes.size());
    for (const Vector3& point : sampleSurface(surface, spacing, kMostSamples))
      require(point.allFinite(), "points of a surface are finite");
  }
  checkMesh(surfaceMesh(polygons.surfaces));
  return true;
}

std::vector<std::string> surfacesSeeds() {
  std::vector<std::string> seeds;
  for (char kind : {'\0', '\2', '\4', '\6'})
    for (char scatter : {'\0', '\1'}) {
      std::string seed = {'\0', '\0', '\0', scatter, '\0'};
      seed += {kind, '\x1f', '\0', '\x17', '\0'};                            // 32x24
      seed += {'\0', '\2', '\5', '\0'};                                      // an ordinary camera, little noise
      seed += std::string(6, '\0');                                          // as it is
      if (kind == 6) seed += {'\3', '\2', '\7', '\4', '\5', '\6'};           // the cloud's pose
      seed += {'\2', '\0', '\x08', '\x04', '\x10', '\xf0', '\x08', '\x18'};  // two planes
      if (scatter == 1)
        for (int i = 0; i < 24; ++i) seed += std::string(8, static_cast<char>('\x40' + i % 3)) + std::string(24, '\0');
      seeds.push_back(seed);
    }
  return seeds;
}

}  // namespace

const FuzzTarget kSurfaces{runSurfaces, surfacesSeeds};

}  // namespace epcc::fuzz
