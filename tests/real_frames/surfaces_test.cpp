// SPDX-License-Identifier: BSD-3-Clause
// Polygons and meshes of rendered scenes, whose areas are known, and of every real frame.
#include <gtest/gtest.h>

#include <iostream>

#include "datasets/rendered/rendered_scenes.h"
#include "datasets/rendered/scene.h"
#include "datasets/sources/dataset_registry.h"
#include "epcc_segmentation/plane_extractor.h"
#include "epcc_segmentation/plane_fit.h"
#include "epcc_segmentation/surface_mesh.h"
#include "epcc_segmentation/surface_polygon.h"
#include "tests/support/real_frames.h"
#include "tests/support/surface_checks.h"

namespace epcc {
namespace {

PlaneSegmentation truthOf(const LabelledFrame& frame, const SensorModel& sensor) {
  PlaneSegmentation segmentation;
  segmentation.width = frame.depth.width;
  segmentation.height = frame.depth.height;
  int count = 0;
  for (const std::uint16_t label : frame.labels.data) {
    segmentation.labels.push_back(label == kIgnoreLabel ? 0 : label);
    count = std::max(count, segmentation.labels.back());
  }
  EXPECT_TRUE(fitPlanes(frameView(frame), sensor, count, segmentation));
  return segmentation;
}

class RenderedSurfaces : public ::testing::TestWithParam<std::string> {};

/// What half a pixel along the edges of a surface covers of its plane at most, square metres.
double halfPixels(const SurfacePolygons& polygons, const SurfacePolygon& surface, const PinholeCamera& camera) {
  double area = 0.0;
  for (const PlaneEdge& edge : polygons.edges) {
    if (edge.first != surface.label && edge.second != surface.label) continue;
    double pixel = 0.0;
    for (const Vector3& p : {edge.start, edge.end})
      pixel = std::max(pixel, p.squaredNorm() / (camera.fx * std::abs(surface.basis.normal.dot(p))));
    area += 0.5 * pixel * edge.length;
  }
  return area;
}

/// Of each surface, as the pixels have its border and with its edges closed: a border that is moved onto an edge may
/// differ from the pixels' by half a pixel, all along.
TEST_P(RenderedSurfaces, AreasAreThoseOfThePixels) {
  const SensorModel sensor = SensorModel::preset("rendered").value();
  for (const std::uint64_t seed : {0, 1, 2}) {
    const LabelledFrame frame = renderScene(GetParam(), seed);
    const PlaneSegmentation truth = truthOf(frame, sensor);
    for (const bool closed : {false, true}) {
      PolygonOptions options;
      options.close_edges = closed;
      const SurfacePolygons polygons = surfacePolygons(frameView(frame), sensor, truth, options);
      const SurfaceMesh mesh = surfaceMesh(polygons.surfaces);
      test::expectSoundSurfaces(polygons, mesh);
      ASSERT_EQ(polygons.surfaces.size(), truth.planes.size());
      for (const SurfacePolygon& surface : polygons.surfaces) {
        const double closing = closed ? halfPixels(polygons, surface, frame.camera.camera) : 0.0;
        EXPECT_NEAR(mesh.totalArea(surface.label), surface.pixel_area, std::max(0.01 * surface.pixel_area, closing))
            << GetParam() << ' ' << seed << " surface " << surface.label << (closed ? " closed" : "");
      }
    }
  }
}

/// Along each edge that was found between two surfaces, their triangles share sides.
TEST_P(RenderedSurfaces, MeshIsClosedAlongEdges) {
  const SensorModel sensor = SensorModel::preset("rendered").value();
  const LabelledFrame frame = renderScene(GetParam(), 0);
  const SurfacePolygons polygons = surfacePolygons(frameView(frame), sensor, truthOf(frame, sensor));
  const SurfaceMesh mesh = surfaceMesh(polygons.surfaces);
  double shared = 0.0, length = 0.0;
  std::set<std::pair<int, int>> pairs;
  for (const PlaneEdge& edge : polygons.edges) {
    length += edge.length;
    if (pairs.insert({edge.first, edge.second}).second) shared += test::sharedLength(mesh, edge.first, edge.second);
  }
  EXPECT_GE(polygons.edges.size(), 3U);
  EXPECT_NEAR(shared, length, 0.02 * length);
}

/// A border that has to keep its area, or crosses another at one place, is not drawn pixel by pixel all along: the
/// rooms' straight borders are a few lines each.
TEST_P(RenderedSurfaces, StraightBordersAreFewLines) {
  const SensorModel sensor = SensorModel::preset("realsense").value();
  std::size_t points = 0, surfaces = 0;
  for (const std::uint64_t seed : {0, 1, 2}) {
    const LabelledFrame frame = renderScene(GetParam(), seed);
    for (const SurfacePolygon& surface : surfacePolygons(frameView(frame), sensor, truthOf(frame, sensor)).surfaces) {
      ++surfaces;
      for (const SurfacePiece& piece : surface.pieces) points += piece.outline.points.size();
    }
  }
  ASSERT_GE(surfaces, 12U);
  EXPECT_LE(points, 14 * surfaces);
}

INSTANTIATE_TEST_SUITE_P(Scenes, RenderedSurfaces, ::testing::Values("a", "b", "c", "d"));

TEST(RenderedSurfaces, NoisyScenesAreSound) {
  NoiseOptions noise;
  noise.kind = NoiseKind::Stereo;
  for (const char* scene : {"a", "b", "c", "d"}) {
    SCOPED_TRACE(scene);
    const LabelledFrame frame = sceneWithNoise(scene, noise)(0);
    PlaneExtractor extractor;
    PlaneSegmentation segmentation;
    ASSERT_TRUE(extractor.extract(frameView(frame), segmentation));
    const SurfacePolygons polygons = surfacePolygons(frameView(frame), extractor.sensor(), segmentation);
    test::expectSoundSurfaces(polygons, surfaceMesh(polygons.surfaces));
  }
}

class RealSurfaces : public ::testing::TestWithParam<std::string> {};

TEST_P(RealSurfaces, EveryFrameIsSound) {
  const std::string folder = GetParam().substr(GetParam().find(':') + 1);
  EPCC_NEED_REAL_FRAMES(folder);
  const std::string format = GetParam().substr(0, GetParam().find(':'));
  const auto source = openDataset((format == "native" ? "" : format + ":") + test::realFolder(folder));
  int surfaces = 0, mended = 0;
  double area = 0.0, pixel_area = 0.0;
  const std::size_t step = std::max<std::size_t>(1, source->size() / 20);  // a sequence need not be looked at whole
  for (std::size_t i = 0; i < source->size(); i += step) {
    const LabelledFrame frame = source->read(i);
    SCOPED_TRACE(frame.name);
    PlaneExtractor extractor;
    PlaneSegmentation segmentation;
    ASSERT_TRUE(extractor.extract(frameView(frame), segmentation)) << extractor.error();
    for (const OutlinePlacement placement : {OutlinePlacement::AlongRay, OutlinePlacement::Orthogonal}) {
      if (placement == OutlinePlacement::Orthogonal && i / step % 4 != 0) continue;
      PolygonOptions options;
      options.placement = placement;
      const SurfacePolygons polygons = surfacePolygons(frameView(frame), extractor.sensor(), segmentation, options);
      test::expectSoundSurfaces(polygons, surfaceMesh(polygons.surfaces));
      if (placement == OutlinePlacement::Orthogonal) continue;
      for (const SurfacePolygon& surface : polygons.surfaces) {
        EXPECT_FALSE(surface.pieces.empty()) << surface.label;
        ++surfaces;
        mended += surface.is_mended ? 1 : 0;
        area += surface.area;
        pixel_area += surface.pixel_area;
      }
    }
  }
  EXPECT_GT(surfaces, 0);
  EXPECT_LE(mended, surfaces / 50);
  EXPECT_NEAR(area, pixel_area, 0.01 * pixel_area);
  RecordProperty("surfaces", surfaces);
  RecordProperty("mended", mended);
}

INSTANTIATE_TEST_SUITE_P(Each, RealSurfaces,
                         ::testing::Values("native:realsense", "native:kinect", "native:abw", "native:icl",
                                           "native:structure", "native:sequence", "pcd:synpeb", "pcd:kinect"),
                         [](const auto& tested) {
                           std::string name = tested.param;
                           std::replace(name.begin(), name.end(), ':', '_');
                           return name;
                         });

}  // namespace
}  // namespace epcc
