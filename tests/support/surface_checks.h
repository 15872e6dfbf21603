// SPDX-License-Identifier: BSD-3-Clause
// What holds of all polygons and meshes, checked with GEOS alone.
#pragma once

#define GEOS_USE_ONLY_R_API
#include <geos_c.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <map>
#include <memory>
#include <set>
#include <utility>
#include <vector>

#include "epcc_segmentation/surface_mesh.h"
#include "epcc_segmentation/surface_polygon.h"

namespace epcc::test {

inline double flatArea(const std::vector<Vector2>& ring) {
  double sum = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vector2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
    sum += a.x() * b.y() - a.y() * b.x();
  }
  return 0.5 * sum;
}

class Geos {
 public:
  using Shape = std::shared_ptr<GEOSGeometry>;
  Geos() : context_(GEOS_init_r()) {}
  ~Geos() { GEOS_finish_r(context_); }

  Shape polygon(const SurfacePiece& piece) const {
    std::vector<GEOSGeometry*> holes;
    for (const SurfaceRing& hole : piece.holes) holes.push_back(ring(hole.flat));
    return own(GEOSGeom_createPolygon_r(context_, ring(piece.outline.flat), holes.data(),
                                        static_cast<unsigned>(holes.size())));
  }
  Shape together(const SurfacePolygon& surface) const {
    std::vector<GEOSGeometry*> parts;
    for (const SurfacePiece& piece : surface.pieces) parts.push_back(GEOSGeom_clone_r(context_, polygon(piece).get()));
    return own(
        GEOSGeom_createCollection_r(context_, GEOS_MULTIPOLYGON, parts.data(), static_cast<unsigned>(parts.size())));
  }
  bool isValid(const Shape& shape) const { return GEOSisValid_r(context_, shape.get()) == 1; }
  /// How many of the points lie outside.
  int outside(const Shape& shape, const std::vector<Vector2>& points) const {
    const GEOSPreparedGeometry* prepared = GEOSPrepare_r(context_, shape.get());
    int count = 0;
    for (const Vector2& p : points) {
      const Shape point = own(GEOSGeom_createPointFromXY_r(context_, p.x(), p.y()));
      if (GEOSPreparedIntersects_r(context_, prepared, point.get()) == 1) continue;
      double distance = 0.0;  // of a triangle as thin as rounding
      GEOSPreparedDistance_r(context_, prepared, point.get(), &distance);
      count += distance > 1e-9 ? 1 : 0;
    }
    GEOSPreparedGeom_destroy_r(context_, prepared);
    return count;
  }

 private:
  GEOSGeometry* ring(const std::vector<Vector2>& points) const {
    std::vector<double> numbers;
    for (const Vector2& p : points) numbers.insert(numbers.end(), {p.x(), p.y()});
    numbers.insert(numbers.end(), {points[0].x(), points[0].y()});
    return GEOSGeom_createLinearRing_r(
        context_,
        GEOSCoordSeq_copyFromBuffer_r(context_, numbers.data(), static_cast<unsigned>(numbers.size() / 2), 0, 0));
  }
  Shape own(GEOSGeometry* shape) const {
    return Shape(shape, [context = context_](GEOSGeometry* g) {
      if (g != nullptr) GEOSGeom_destroy_r(context, g);
    });
  }
  GEOSContextHandle_t context_;
};

/// Valid, outlines counter-clockwise and holes clockwise, points on the plane and where the flat ones are, area and
/// perimeter those of the rings, all within the extent.
inline void expectSoundPolygon(const SurfacePolygon& surface, const Geos& geos) {
  SCOPED_TRACE("surface " + std::to_string(surface.label));
  double area = 0.0;
  const PlaneBasis& basis = surface.basis;
  ASSERT_NEAR((basis.across.cross(basis.up) - basis.normal).norm(), 0.0, 1e-9);
  const auto expectRing = [&](const SurfaceRing& ring, bool is_outline) {
    ASSERT_GE(ring.flat.size(), 3U);
    ASSERT_EQ(ring.flat.size(), ring.points.size());
    const double own = flatArea(ring.flat);
    EXPECT_TRUE(is_outline ? own > 0.0 : own < 0.0) << own;
    area += own;
    for (std::size_t i = 0; i < ring.flat.size(); ++i) {
      const double size = 1.0 + ring.points[i].norm();
      EXPECT_NEAR((basis.point(ring.flat[i]) - ring.points[i]).norm(), 0.0, 1e-6 * size);
      const Eigen::Vector3d from_center = ring.points[i] - surface.extent.center;
      EXPECT_LE(std::abs(from_center.dot(surface.extent.long_axis)), 0.5 * surface.extent.length + 1e-6 * size);
      EXPECT_LE(std::abs(from_center.dot(surface.extent.short_axis)), 0.5 * surface.extent.width + 1e-6 * size);
    }
  };
  for (const SurfacePiece& piece : surface.pieces) {
    expectRing(piece.outline, true);
    for (const SurfaceRing& hole : piece.holes) expectRing(hole, false);
  }
  EXPECT_NEAR(surface.area, area, 1e-9 * (1.0 + area));
  if (surface.pieces.empty()) return;
  EXPECT_TRUE(geos.isValid(geos.together(surface)));
  EXPECT_LE(surface.area, surface.extent.length * surface.extent.width * (1.0 + 1e-9));
}

/// No triangle outside of the polygon, all of it covered, triangles counter-clockwise for the sensor.
inline void expectSoundMesh(const SurfaceMesh& mesh, const std::vector<SurfacePolygon>& surfaces, const Geos& geos) {
  ASSERT_EQ(mesh.triangles.size(), mesh.labels.size());
  std::map<int, std::vector<Vector2>> points;  // along the sides of each triangle, a little inside, and its middle
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const SurfacePolygon& surface = surfaces[static_cast<std::size_t>(mesh.labels[i] - 1)];
    Vector2 corners[3];
    for (std::size_t k = 0; k < 3; ++k)
      corners[k] = surface.basis.flat(mesh.vertices[static_cast<std::size_t>(mesh.triangles[i][k])]);
    ASSERT_GT(flatArea({corners[0], corners[1], corners[2]}), -1e-12) << i;
    const Vector2 middle = (corners[0] + corners[1] + corners[2]) / 3.0;
    points[mesh.labels[i]].push_back(middle);
    for (int k = 0; k < 3; ++k)
      for (const double share : {0.02, 0.25, 0.5, 0.75})
        points[mesh.labels[i]].push_back(middle +
                                         0.999 * ((1.0 - share) * corners[k] + share * corners[(k + 1) % 3] - middle));
  }
  for (const SurfacePolygon& surface : surfaces) {
    SCOPED_TRACE("surface " + std::to_string(surface.label));
    EXPECT_NEAR(mesh.totalArea(surface.label), surface.area, 1e-6 * (1e-6 + surface.area));
    if (surface.pieces.empty()) {
      EXPECT_TRUE(points[surface.label].empty());
      continue;
    }
    EXPECT_EQ(geos.outside(geos.together(surface), points[surface.label]), 0);
  }
}

/// Length of the triangles' sides that a triangle of either label has.
inline double sharedLength(const SurfaceMesh& mesh, int first, int second) {
  std::set<std::pair<int, int>> of_first;
  double length = 0.0;
  for (const int label : {first, second})
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
      for (std::size_t k = 0; mesh.labels[i] == label && k < 3; ++k) {
        const std::pair<int, int> side = std::minmax(mesh.triangles[i][k], mesh.triangles[i][(k + 1) % 3]);
        if (label == first)
          of_first.insert(side);
        else if (of_first.count(side) != 0)
          length += (mesh.vertices[static_cast<std::size_t>(side.first)] -
                     mesh.vertices[static_cast<std::size_t>(side.second)])
                        .norm();
      }
  return length;
}

/// Both at once.
inline void expectSoundSurfaces(const SurfacePolygons& polygons, const SurfaceMesh& mesh) {
  const Geos geos;
  EXPECT_EQ(polygons.problem, "");
  for (std::size_t k = 0; k < polygons.surfaces.size(); ++k) {
    EXPECT_EQ(polygons.surfaces[k].label, static_cast<int>(k) + 1);
    expectSoundPolygon(polygons.surfaces[k], geos);
  }
  expectSoundMesh(mesh, polygons.surfaces, geos);
}

}  // namespace epcc::test
