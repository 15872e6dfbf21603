// SPDX-License-Identifier: BSD-3-Clause
// Edges between planes and meshes that are closed along them: rendered rooms and boxes, cameras, clouds and scans.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include "epcc_segmentation/plane_edges.h"
#include "epcc_segmentation/plane_extractor.h"
#include "epcc_segmentation/plane_fit.h"
#include "epcc_segmentation/surface_mesh.h"
#include "epcc_segmentation/surface_polygon.h"
#include "tests/support/posed_clouds.h"
#include "tests/support/rendered_room.h"
#include "tests/support/surface_checks.h"

namespace epcc {
namespace {

const SensorModel& exactSensor() {
  static const SensorModel sensor = SensorModel::preset("rendered").value();
  return sensor;
}

PlaneSegmentation withPlanes(const DepthFrame& frame, const std::vector<std::int32_t>& labels, int width, int height,
                             int count) {
  PlaneSegmentation segmentation;
  segmentation.width = width;
  segmentation.height = height;
  segmentation.labels = labels;
  EXPECT_TRUE(fitPlanes(frame, exactSensor(), count, segmentation));
  return segmentation;
}

/// A depth image with its labels, drawn pixel by pixel.
struct DrawnScene {
  PinholeCamera camera = test::testCamera();
  std::vector<float> depth;
  std::vector<std::int32_t> labels;
  int planes = 0;

  /// draw(u, v, column) gives the depth, 0 for nothing, and the label.
  template <typename Draw>
  DrawnScene(int count, const Draw& draw) : planes(count) {
    for (int row = 0; row < camera.height; ++row)
      for (int column = 0; column < camera.width; ++column) {
        const std::pair<double, int> pixel =
            draw((column - camera.cx) / camera.fx, (row - camera.cy) / camera.fy, column);
        depth.push_back(static_cast<float>(pixel.first));
        labels.push_back(pixel.second);
      }
  }
  DepthFrame frame() const { return DepthFrame::fromDepth(depth.data(), camera); }
  PlaneSegmentation segmentation() const { return withPlanes(frame(), labels, camera.width, camera.height, planes); }
};

/// The mesh's sides that both planes have are as long as their edges.
void expectClosed(const SurfacePolygons& polygons, const SurfaceMesh& mesh) {
  std::map<std::pair<int, int>, double> lengths;
  for (const PlaneEdge& edge : polygons.edges) lengths[{edge.first, edge.second}] += edge.length;
  for (const auto& [pair, length] : lengths) {
    SCOPED_TRACE(std::to_string(pair.first) + " and " + std::to_string(pair.second));
    EXPECT_NEAR(test::sharedLength(mesh, pair.first, pair.second), length, 1e-6 * length);
  }
}

TEST(PlaneEdges, CornerOfARoomIsClosed) {
  test::RenderedRoom room = test::renderRoom(test::cornerPlanes(), test::testCamera());
  const PlaneSegmentation segmentation = withPlanes(room.frame(), room.labels, 160, 120, 3);
  const SurfacePolygons polygons = surfacePolygons(room.frame(), exactSensor(), segmentation);
  const SurfaceMesh mesh = surfaceMesh(polygons.surfaces);
  test::expectSoundSurfaces(polygons, mesh);
  ASSERT_EQ(polygons.edges.size(), 3U);
  expectClosed(polygons, mesh);
  // All three end in the corner that the planes have in common, which is one vertex.
  Eigen::Matrix3d normals;
  Eigen::Vector3d offsets;
  for (int k = 0; k < 3; ++k) {
    normals.row(k) = segmentation.planes[static_cast<std::size_t>(k)].coefficients.head<3>().transpose();
    offsets(k) = -segmentation.planes[static_cast<std::size_t>(k)].coefficients(3);
  }
  const Eigen::Vector3d corner = normals.inverse() * offsets;
  for (const PlaneEdge& edge : polygons.edges) {
    EXPECT_FALSE(edge.convex);
    EXPECT_NEAR(std::min((edge.start - corner).norm(), (edge.end - corner).norm()), 0.0, 1e-6);
    const auto& first = segmentation.planes[static_cast<std::size_t>(edge.first - 1)];
    const auto& second = segmentation.planes[static_cast<std::size_t>(edge.second - 1)];
    EXPECT_NEAR(std::cos(edge.angle), first.coefficients.head<3>().dot(second.coefficients.head<3>()), 1e-9);
    for (const Vector3& p : {edge.start, edge.end}) {
      EXPECT_NEAR(first.signedDistance(p), 0.0, 1e-9);
      EXPECT_NEAR(second.signedDistance(p), 0.0, 1e-9);
    }
    EXPECT_LT(edge.offset, 0.6);
    EXPECT_GT(edge.pixels, 20);
  }
  int vertices = 0;
  for (const Vector3& v : mesh.vertices) vertices += (v - corner).norm() < 1e-6 ? 1 : 0;
  EXPECT_EQ(vertices, 1);
  EXPECT_EQ(planeEdges(room.frame(), exactSensor(), segmentation).size(), 3U);
}

TEST(PlaneEdges, AreasAreThoseOfThePixels) {
  const test::RenderedRoom room = test::renderRoom(test::cornerPlanes(), test::testCamera(640, 480));
  const PlaneSegmentation segmentation = withPlanes(room.frame(), room.labels, 640, 480, 3);
  PolygonOptions apart;
  apart.close_edges = false;
  for (const PolygonOptions& options : {PolygonOptions(), apart}) {
    const SurfacePolygons polygons = surfacePolygons(room.frame(), exactSensor(), segmentation, options);
    for (const SurfacePolygon& surface : polygons.surfaces) {
      double area = 0.0;  // of the pixels, each cut out of the plane by the rays of its corners
      const Plane& plane = segmentation.planes[static_cast<std::size_t>(surface.label - 1)];
      const Eigen::Vector3d normal = plane.coefficients.head<3>();
      for (int row = 0; row < 480; ++row)
        for (int column = 0; column < 640; ++column) {
          if (segmentation.labels[static_cast<std::size_t>(row * 640 + column)] != surface.label) continue;
          const auto corner = [&](double r, double c) -> Eigen::Vector3d {
            const Eigen::Vector3d ray((c - room.camera.cx) / room.camera.fx, (r - room.camera.cy) / room.camera.fy,
                                      1.0);
            return ray * (-plane.coefficients(3) / normal.dot(ray));
          };
          const Eigen::Vector3d a = corner(row - 0.5, column - 0.5), b = corner(row - 0.5, column + 0.5),
                                c = corner(row + 0.5, column + 0.5), d = corner(row + 0.5, column - 0.5);
          area += 0.5 * (c - a).cross(d - b).norm();
        }
      EXPECT_NEAR(surface.pixel_area, area, 0.002 * area);
      EXPECT_NEAR(surface.area, area, 0.01 * area) << surface.label;
    }
  }
}

/// Two walls of a box that stand out to the camera, right in front of it.
TEST(PlaneEdges, BoxIsConvex) {
  const DrawnScene scene(2, [](double u, double, int) {
    const double left = 1.0 / (1.0 - u), right = 1.0 / (1.0 + u);  // z = 1 -+ x: edge at x = 0, z = 1
    return std::pair<double, int>(std::max(left, right), left > right ? 2 : 1);
  });
  const DepthFrame frame = scene.frame();
  const PlaneSegmentation segmentation = scene.segmentation();
  const SurfacePolygons polygons = surfacePolygons(frame, exactSensor(), segmentation);
  const SurfaceMesh mesh = surfaceMesh(polygons.surfaces);
  test::expectSoundSurfaces(polygons, mesh);
  ASSERT_EQ(polygons.edges.size(), 1U);
  const PlaneEdge& edge = polygons.edges[0];
  EXPECT_TRUE(edge.convex);
  EXPECT_NEAR(edge.angle, M_PI_2, 1e-4);
  EXPECT_NEAR(edge.length, scene.camera.height / scene.camera.fy, 1e-3);
  // `first` is to the left of the way from start to end.
  const Eigen::Vector3d way = edge.end - edge.start;
  const bool first_is_left = segmentation.planes[0].centroid.x() < 0.0;
  EXPECT_EQ(way.y() < 0.0, first_is_left);
  expectClosed(polygons, mesh);
}

/// Pixels that the noise gave to the wrong one of two walls, near their corner.
TEST(PlaneEdges, IslandBesideTheLineIsNoEdge) {
  const DrawnScene scene(2, [](double u, double v, int column) {
    const double left = 1.0 / (1.0 - u), right = 1.0 / (1.0 + u);
    const bool is_island = column >= 76 && column <= 77 && std::abs(v) < 0.1;
    return std::pair<double, int>(std::max(left, right), left > right || is_island ? 2 : 1);
  });
  const DepthFrame frame = scene.frame();
  const PlaneSegmentation segmentation = scene.segmentation();
  const SurfacePolygons polygons = surfacePolygons(frame, exactSensor(), segmentation);
  test::expectSoundSurfaces(polygons, surfaceMesh(polygons.surfaces));
  ASSERT_EQ(polygons.edges.size(), 1U);
  EXPECT_GT(polygons.edges[0].length, 0.5);
  EXPECT_EQ(polygons.edges[0].pixels, scene.camera.height);
}

TEST(PlaneEdges, StepIsNoEdge) {
  // A wall, and before it a panel that is turned and meets the wall's plane far away from its border.
  const DrawnScene scene(2, [](double u, double, int column) {
    return column < 80 ? std::pair<double, int>(1.0 / (1.0 + 0.3 * u), 1) : std::pair<double, int>(2.0, 2);
  });
  const DepthFrame frame = scene.frame();
  const PlaneSegmentation segmentation = scene.segmentation();
  const SurfacePolygons polygons = surfacePolygons(frame, exactSensor(), segmentation);
  EXPECT_TRUE(polygons.edges.empty());
  test::expectSoundSurfaces(polygons, surfaceMesh(polygons.surfaces));
}

TEST(PlaneEdges, GapIsBridged) {
  test::RenderedRoom room = test::renderRoom(test::cornerPlanes(), test::testCamera());
  std::vector<std::int32_t> labels = room.labels;
  for (int row = 0; row < 120; ++row)  // a gap of two pixels beside each border
    for (int column = 0; column < 160; ++column)
      for (int k = 1; k < 3; ++k) {
        const auto at = static_cast<std::size_t>(row * 160 + column);
        if (column + k < 160 && room.labels[at] != room.labels[at + static_cast<std::size_t>(k)]) labels[at] = 0;
      }
  const PlaneSegmentation segmentation = withPlanes(room.frame(), labels, 160, 120, 3);
  const SurfacePolygons polygons = surfacePolygons(room.frame(), exactSensor(), segmentation);
  const SurfaceMesh mesh = surfaceMesh(polygons.surfaces);
  test::expectSoundSurfaces(polygons, mesh);
  EXPECT_GE(polygons.edges.size(), 2U);
  expectClosed(polygons, mesh);
  PolygonOptions options;
  options.edges.max_gap = 0;
  EXPECT_LT(surfacePolygons(room.frame(), exactSensor(), segmentation, options).edges.size(), polygons.edges.size());
}

TEST(PlaneEdges, NoisyRoomSegmented) {
  const SensorModel sensor = *SensorModel::parse("0.002,0.001,1");
  for (unsigned seed = 0; seed < 3; ++seed) {
    test::RenderedRoom room = test::renderRoom(test::cornerPlanes(), test::testCamera(320, 240));
    test::addNoise(room, sensor, seed);
    PlaneExtractor extractor(Parameters(), sensor);
    PlaneSegmentation segmentation;
    ASSERT_TRUE(extractor.extract(room.frame(), segmentation));
    ASSERT_EQ(segmentation.planes.size(), 3U);
    const SurfacePolygons polygons = surfacePolygons(room.frame(), sensor, segmentation);
    const SurfaceMesh mesh = surfaceMesh(polygons.surfaces);
    test::expectSoundSurfaces(polygons, mesh);
    ASSERT_GE(polygons.edges.size(), 3U);
    for (const SurfacePolygon& surface : polygons.surfaces)
      EXPECT_NEAR(surface.area, surface.pixel_area, 0.01 * surface.pixel_area);
    for (const OutlinePlacement placement : {OutlinePlacement::AlongRay, OutlinePlacement::Orthogonal}) {
      PolygonOptions options;
      options.placement = placement;
      options.close_edges = false;
      const SurfacePolygons apart = surfacePolygons(room.frame(), sensor, segmentation, options);
      test::expectSoundSurfaces(apart, surfaceMesh(apart.surfaces));
      for (const SurfacePolygon& surface : apart.surfaces)
        EXPECT_NEAR(surface.area, surface.pixel_area,
                    (placement == OutlinePlacement::AlongRay ? 0.01 : 0.04) * surface.pixel_area);
    }
  }
}

TEST(PlaneEdges, CloudInAnyFrameGivesTheSameInThatFrame) {
  const test::PosedCloud cloud = test::cameraCloud(test::renderRoom(test::cornerPlanes(), test::testCamera()));
  const Eigen::Matrix3d axes = Eigen::AngleAxisd(2.0, Eigen::Vector3d(1.0, -2.0, 0.5).normalized()).toRotationMatrix();
  const Eigen::Vector3d origin(4.0, -1.0, 2.0);
  const test::PosedCloud turned = test::moved(cloud, axes, origin);
  const auto surfacesOf = [](const test::PosedCloud& own) {
    const CloudGeometry geometry = findGeometry(own.xyz.data(), 3, own.width, own.height);
    const DepthFrame frame = DepthFrame::fromPoints(own.xyz.data(), 3, own.width, own.height, geometry);
    return surfacePolygons(frame, exactSensor(), withPlanes(frame, own.truth, own.width, own.height, 3));
  };
  const SurfacePolygons own = surfacesOf(cloud), other = surfacesOf(turned);
  test::expectSoundSurfaces(other, surfaceMesh(other.surfaces));
  ASSERT_EQ(own.surfaces.size(), 3U);
  ASSERT_EQ(other.surfaces.size(), 3U);
  ASSERT_EQ(own.edges.size(), other.edges.size());
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(own.surfaces[k].area, other.surfaces[k].area, 0.002 * own.surfaces[k].area);
    EXPECT_NEAR((axes * own.surfaces[k].extent.center + origin - other.surfaces[k].extent.center).norm(), 0.0, 0.02);
    EXPECT_NEAR((axes * own.surfaces[k].basis.normal - other.surfaces[k].basis.normal).norm(), 0.0, 0.01);
  }
}

TEST(PlaneEdges, ScanThatClosesRound) {
  // Four walls round the scanner: the one behind the seam is one piece.
  const test::PosedCloud cloud = test::scannerCloud(720, 40);
  const CloudGeometry geometry = findGeometry(cloud.xyz.data(), 3, cloud.width, cloud.height);
  ASSERT_TRUE(geometry.grid.closes_round);
  const DepthFrame frame = DepthFrame::fromPoints(cloud.xyz.data(), 3, cloud.width, cloud.height, geometry);
  const PlaneSegmentation segmentation = withPlanes(frame, cloud.truth, cloud.width, cloud.height, 4);
  const SurfacePolygons polygons = surfacePolygons(frame, SensorModel::axial(0.008, 0.0), segmentation);
  const SurfaceMesh mesh = surfaceMesh(polygons.surfaces);
  test::expectSoundSurfaces(polygons, mesh);
  EXPECT_EQ(polygons.edges.size(), 4U);
  expectClosed(polygons, mesh);
  for (const SurfacePolygon& surface : polygons.surfaces) {
    EXPECT_EQ(surface.pieces.size(), 1U) << surface.label;
    EXPECT_NEAR(surface.area, surface.pixel_area, 0.02 * surface.pixel_area);
  }
  for (const PlaneEdge& edge : polygons.edges) {
    EXPECT_FALSE(edge.convex);
    EXPECT_NEAR(edge.angle, M_PI_2, 0.02);
  }
}

TEST(PlaneEdges, RingsAsColumnsAndInAnyOrderGiveTheSame) {
  const test::PosedCloud cloud = test::scannerCloud(720, 40);
  const auto surfacesOf = [](const test::PosedCloud& own) {
    const CloudGeometry geometry = findGeometry(own.xyz.data(), 3, own.width, own.height);
    EXPECT_EQ(geometry.problem, "");
    const DepthFrame frame = DepthFrame::fromPoints(own.xyz.data(), 3, own.width, own.height, geometry);
    return surfacePolygons(frame, SensorModel::axial(0.008, 0.0),
                           withPlanes(frame, own.truth, own.width, own.height, 4));
  };
  const SurfacePolygons own = surfacesOf(cloud);
  const test::PosedCloud turned = test::rowsAndColumnsExchanged(cloud);
  const test::PosedCloud shuffled = test::reordered(
      cloud, 720, 40, [](int row, int column) { return static_cast<std::size_t>((row * 7 % 40) * 720 + column); });
  for (const test::PosedCloud* other : {&turned, &shuffled}) {
    const SurfacePolygons polygons = surfacesOf(*other);
    test::expectSoundSurfaces(polygons, surfaceMesh(polygons.surfaces));
    ASSERT_EQ(polygons.surfaces.size(), own.surfaces.size());
    EXPECT_EQ(polygons.edges.size(), own.edges.size());
    for (std::size_t k = 0; k < own.surfaces.size(); ++k) {
      EXPECT_EQ(polygons.surfaces[k].pieces.size(), 1U);
      EXPECT_NEAR(polygons.surfaces[k].area, own.surfaces[k].area, 0.01 * own.surfaces[k].area);
    }
  }
}

TEST(PlaneEdges, FloorRoundAScannerIsARing) {
  const int width = 360, height = 30;
  std::vector<float> xyz;
  std::vector<std::int32_t> labels(static_cast<std::size_t>(width * height), 1);
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column) {
      const double azimuth = -2.0 * M_PI * column / width, elevation = -0.3 - 0.02 * row;
      const double distance = 1.0 / -std::tan(elevation);  // the floor is 1 m below
      for (const double value : {distance * std::cos(azimuth), distance * std::sin(azimuth), -1.0})
        xyz.push_back(static_cast<float>(value));
    }
  const DepthFrame frame = DepthFrame::fromPoints(xyz.data(), 3, width, height, Projection::Spherical).closedRound();
  const PlaneSegmentation segmentation = withPlanes(frame, labels, width, height, 1);
  const SurfacePolygons polygons = surfacePolygons(frame, exactSensor(), segmentation);
  const SurfaceMesh mesh = surfaceMesh(polygons.surfaces);
  test::expectSoundSurfaces(polygons, mesh);
  ASSERT_EQ(polygons.surfaces[0].pieces.size(), 1U);
  ASSERT_EQ(polygons.surfaces[0].pieces[0].holes.size(), 1U);
  const double outer = 1.0 / std::tan(0.29), inner = 1.0 / std::tan(0.3 + 0.02 * 29 + 0.01);
  EXPECT_NEAR(polygons.surfaces[0].area, M_PI * (outer * outer - inner * inner), 0.01 * M_PI * outer * outer);
}

TEST(PlaneEdges, FloorToTheHorizonStaysFinite) {
  const DrawnScene scene(1, [](double, double v, int) {
    return v > 0.0 ? std::pair<double, int>(1.0 / v, 1) : std::pair<double, int>(0.0, 0);
  });
  const DepthFrame frame = scene.frame();
  const PlaneSegmentation segmentation = scene.segmentation();
  const SurfacePolygons polygons = surfacePolygons(frame, exactSensor(), segmentation);
  test::expectSoundSurfaces(polygons, surfaceMesh(polygons.surfaces));
  ASSERT_FALSE(polygons.surfaces[0].pieces.empty());
  for (const Vector3& p : polygons.surfaces[0].pieces[0].outline.points) EXPECT_LT(p.norm(), 1000.0);
}

/// Labels that have nothing to do with what was measured: whatever comes out is sound.
TEST(PlaneEdges, WrongLabelsDoNoHarm) {
  std::mt19937 random(5);
  const PinholeCamera camera = test::testCamera(40, 30);
  for (int i = 0; i < 40; ++i) {
    SCOPED_TRACE(i);
    const test::RenderedRoom room = test::renderRoom(test::cornerPlanes(), camera);
    std::vector<std::int32_t> labels = room.labels;
    for (std::int32_t& label : labels)
      if (random() % 8 == 0) label = static_cast<std::int32_t>(random() % 4);
    const PlaneSegmentation segmentation = withPlanes(room.frame(), labels, 40, 30, 3);
    for (const OutlinePlacement placement : {OutlinePlacement::AlongRay, OutlinePlacement::Orthogonal}) {
      PolygonOptions options;
      options.placement = placement;
      const SurfacePolygons polygons = surfacePolygons(room.frame(), exactSensor(), segmentation, options);
      test::expectSoundSurfaces(polygons, surfaceMesh(polygons.surfaces));
    }
  }
}

}  // namespace
}  // namespace epcc
