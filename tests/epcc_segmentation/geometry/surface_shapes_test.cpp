// SPDX-License-Identifier: BSD-3-Clause
// Polygons and meshes of hand-made regions on a wall that faces the camera.
#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

#include "epcc_segmentation/plane_fit.h"
#include "epcc_segmentation/surface_mesh.h"
#include "epcc_segmentation/surface_polygon.h"
#include "epcc_segmentation/surface_sampling.h"
#include "tests/support/surface_checks.h"

namespace epcc {
namespace {

constexpr double kPixel = 0.02;  // metres, of a pixel on the wall
constexpr double kFootprint = kPixel * kPixel;

/// A wall 2 m ahead; digits are labels.
struct Drawing {
  PinholeCamera camera;
  std::vector<float> depth;
  PlaneSegmentation segmentation;
  int pixels = 0;

  explicit Drawing(const std::vector<std::string>& rows) {
    camera = {static_cast<int>(rows.front().size()), static_cast<int>(rows.size()), 100.0, 100.0, 3.0, 2.0};
    std::vector<std::int32_t> labels;
    for (const std::string& row : rows)
      for (const char c : row) labels.push_back(c == '.' ? 0 : c - '0');
    set(std::move(labels));
  }
  Drawing(int width, int height, std::vector<std::int32_t> labels)
      : camera{width, height, 100.0, 100.0, 0.5 * width, 0.5 * height} {
    set(std::move(labels));
  }
  void set(std::vector<std::int32_t> labels) {
    depth.assign(labels.size(), 2.0f);
    segmentation.width = camera.width;
    segmentation.height = camera.height;
    int count = 0;
    for (const std::int32_t label : labels) {
      pixels += label > 0 ? 1 : 0;
      count = std::max(count, label);
    }
    segmentation.labels = std::move(labels);
    for (int k = 0; k < count; ++k) {
      Plane plane;
      plane.coefficients = Vector4(0.0, 0.0, -1.0, 2.0);
      plane.centroid = Vector3(0.1, 0.2, 2.0);
      segmentation.planes.push_back(plane);
    }
  }
  DepthFrame frame() const { return DepthFrame::fromDepth(depth.data(), camera); }
  SurfacePolygons polygons(const PolygonOptions& options = PolygonOptions()) const {
    return surfacePolygons(frame(), SensorModel::preset("rendered").value(), segmentation, options);
  }
};

/// Sound, and the area that of the pixels but for `share`.
SurfacePolygons checked(const Drawing& drawing, double share = 1e-9, const PolygonOptions& options = PolygonOptions()) {
  SurfacePolygons polygons = drawing.polygons(options);
  const SurfaceMesh mesh = surfaceMesh(polygons.surfaces);
  test::expectSoundSurfaces(polygons, mesh);
  double area = 0.0;
  for (const SurfacePolygon& surface : polygons.surfaces) {
    area += surface.area;
    EXPECT_FALSE(surface.is_mended);
  }
  EXPECT_NEAR(area, drawing.pixels * kFootprint, (1e-9 + share) * drawing.pixels * kFootprint);
  return polygons;
}

TEST(SurfaceShapes, SquareWithAHole) {
  const auto polygons = checked(Drawing({"..........", ".11111111.", ".11111111.", ".111..111.", ".111..111.",
                                         ".111..111.", ".11111111.", ".........."}));
  ASSERT_EQ(polygons.surfaces.size(), 1U);
  const SurfacePolygon& surface = polygons.surfaces[0];
  ASSERT_EQ(surface.pieces.size(), 1U);
  EXPECT_EQ(surface.pieces[0].outline.points.size(), 4U);
  ASSERT_EQ(surface.pieces[0].holes.size(), 1U);
  EXPECT_EQ(surface.pieces[0].holes[0].points.size(), 4U);
  EXPECT_NEAR(surface.pixel_area, (48 - 6) * kFootprint, 1e-9);
  EXPECT_NEAR(surface.perimeter, (28 + 10) * kPixel, 1e-9);
  EXPECT_NEAR(surface.extent.length, 8 * kPixel, 1e-9);
  EXPECT_NEAR(surface.extent.width, 6 * kPixel, 1e-9);
  // The pixels' outer edges: columns 0.5 to 8.5, rows 0.5 to 6.5.
  EXPECT_NEAR((surface.extent.center - Vector3((4.5 - 3.0) * kPixel, (3.5 - 2.0) * kPixel, 2.0)).norm(), 0.0, 1e-9);
  EXPECT_NEAR(std::abs(surface.extent.long_axis.x()), 1.0, 1e-9);
  // The basis is upright: across to the right, up against y.
  EXPECT_NEAR((surface.basis.across - Vector3::UnitX()).norm(), 0.0, 1e-9);
  EXPECT_NEAR((surface.basis.up + Vector3::UnitY()).norm(), 0.0, 1e-9);
  EXPECT_NEAR((surface.basis.origin - Vector3(0.1, 0.2, 2.0)).norm(), 0.0, 1e-9);
}

TEST(SurfaceShapes, PieceInAHoleIsAPiece) {
  const auto polygons = checked(Drawing({"1111111", "1.....1", "1.111.1", "1.111.1", "1.....1", "1111111"}));
  ASSERT_EQ(polygons.surfaces[0].pieces.size(), 2U);
  EXPECT_EQ(polygons.surfaces[0].pieces[0].holes.size(), 1U);
  EXPECT_TRUE(polygons.surfaces[0].pieces[1].holes.empty());
}

TEST(SurfaceShapes, NarrowRegionsKeepTheirArea) {
  for (const std::vector<std::string>& rows : std::vector<std::vector<std::string>>{{"1"},
                                                                                    {"11111111"},
                                                                                    {"1", "1", "1", "1"},
                                                                                    {"...", ".1.", "..."},
                                                                                    {"....", ".11.", "...."},
                                                                                    {"1.1", "...", "1.1"}}) {
    SCOPED_TRACE(rows.front());
    const auto polygons = checked(Drawing(rows));
    EXPECT_FALSE(polygons.surfaces[0].pieces.empty());
  }
}

TEST(SurfaceShapes, PixelsThatTouchAtACornerAreTwoPieces) {
  EXPECT_EQ(checked(Drawing({"11..", "11..", "..11", "..11"})).surfaces[0].pieces.size(), 2U);
  // Round a hole of two pixels that touch at a corner: two holes.
  const auto polygons = checked(Drawing({"1111", "1.11", "11.1", "1111"}));
  ASSERT_EQ(polygons.surfaces[0].pieces.size(), 1U);
  EXPECT_EQ(polygons.surfaces[0].pieces[0].holes.size(), 2U);
  checked(Drawing({"1.1.1.1", ".1.1.1.", "1.1.1.1", ".1.1.1.", "1.1.1.1"}));
}

TEST(SurfaceShapes, Bridge) {
  const auto polygons = checked(Drawing({"111....111", "111....111", "1111111111", "111....111", "111....111"}));
  EXPECT_EQ(polygons.surfaces[0].pieces.size(), 1U);
}

TEST(SurfaceShapes, RingAndSpiral) {
  checked(Drawing({"..111..", ".1...1.", "1.....1", "1.....1", ".1...1.", "..111.."}), 0.004);
  checked(Drawing({"1111111111", ".........1", "11111111.1", "1......1.1", "1.1111.1.1", "1.1..1.1.1", "1.1....1.1",
                   "1.111111.1", "1........1", "1111111111"}),
          0.004);
}

TEST(SurfaceShapes, WholeImageAndNothing) {
  const auto whole = checked(Drawing({"1111", "1111", "1111"}));
  EXPECT_EQ(whole.surfaces[0].pieces[0].outline.points.size(), 4U);
  EXPECT_TRUE(checked(Drawing({"....", "...."})).surfaces.empty());
}

TEST(SurfaceShapes, RegionWithoutPixelsHasNoPolygon) {
  Drawing drawing({"111", "111"});
  drawing.segmentation.planes.push_back(drawing.segmentation.planes[0]);
  const auto polygons = checked(drawing);
  ASSERT_EQ(polygons.surfaces.size(), 2U);
  EXPECT_TRUE(polygons.surfaces[1].pieces.empty());
  EXPECT_EQ(polygons.surfaces[1].area, 0.0);
}

TEST(SurfaceShapes, SlantedBorderIsStraight) {
  std::vector<std::int32_t> labels;
  for (int row = 0; row < 60; ++row)
    for (int column = 0; column < 80; ++column) labels.push_back(3 * column + 5 * row < 260 ? 1 : 0);
  const auto polygons = checked(Drawing(80, 60, labels), 0.004);
  EXPECT_LE(polygons.surfaces[0].pieces[0].outline.points.size(), 6U);
  PolygonOptions exact;
  exact.tolerance_pixels = 0.0;
  exact.tolerance_sigma = 0.0;
  EXPECT_GE(checked(Drawing(80, 60, labels), 1e-9, exact).surfaces[0].pieces[0].outline.points.size(), 60U);
}

TEST(SurfaceShapes, SmallRingsAreLeftOutWhileTheAreaIsKept) {
  std::vector<std::int32_t> labels(100 * 100, 1);
  labels[5050] = 0;
  EXPECT_TRUE(checked(Drawing(100, 100, labels), 0.004).surfaces[0].pieces[0].holes.empty());
  PolygonOptions all;
  all.min_ring_pixels = 0;
  all.tolerance_pixels = 0.0;
  EXPECT_EQ(checked(Drawing(100, 100, labels), 1e-9, all).surfaces[0].pieces[0].holes.size(), 1U);
}

TEST(SurfaceShapes, RandomRegionsOfAllKinds) {
  std::mt19937 random(3);
  for (int i = 0; i < 150; ++i) {
    SCOPED_TRACE(i);
    const int width = 1 + static_cast<int>(random() % 24), height = 1 + static_cast<int>(random() % 24);
    const unsigned long kinds = 2 + random() % 3, fill = 2 + random() % 5;
    std::vector<std::int32_t> labels;
    for (int k = 0; k < width * height; ++k) {
      // Blots: a pixel is often like its left or upper neighbour.
      const std::size_t at = labels.size();
      const unsigned long how = random() % fill;
      if (how > 1 && k % width > 0)
        labels.push_back(labels[at - 1]);
      else if (how == 1 && k >= width)
        labels.push_back(labels[at - static_cast<std::size_t>(width)]);
      else
        labels.push_back(static_cast<std::int32_t>(random() % kinds));
    }
    checked(Drawing(width, height, labels), 0.005);
  }
}

TEST(SurfaceShapes, WrongInputIsSaidInWords) {
  Drawing drawing({"111", "111"});
  PolygonOptions options;
  options.tolerance_pixels = -1.0;
  EXPECT_EQ(drawing.polygons(options).status, Status::InvalidParameters);
  EXPECT_EQ(drawing.polygons(options).problem, "tolerance_pixels must be in [0, 100]");
  drawing.segmentation.labels.pop_back();
  EXPECT_EQ(drawing.polygons().status, Status::SizeMismatch);
  EXPECT_TRUE(drawing.polygons().surfaces.empty());
  const DepthFrame none = DepthFrame::fromDepth(nullptr, drawing.camera);
  EXPECT_EQ(surfacePolygons(none, SensorModel::axial(0.01, 0.0), drawing.segmentation).status, Status::EmptyCloud);
}

TEST(SurfaceShapes, LabelsWithoutAPlaneAndPlanesThroughTheSensor) {
  Drawing drawing({"12223", "12223", "12223"});
  drawing.segmentation.planes.resize(2);
  drawing.segmentation.planes[1].coefficients = Vector4(1.0, 0.0, 0.0, 0.0);
  const SurfacePolygons polygons = drawing.polygons();
  test::expectSoundSurfaces(polygons, surfaceMesh(polygons.surfaces));
  ASSERT_EQ(polygons.surfaces.size(), 2U);
  EXPECT_NEAR(polygons.surfaces[0].area, 3 * kFootprint, 1e-12);
  EXPECT_TRUE(polygons.surfaces[1].pieces.empty());
}

TEST(SurfaceSampling, GridInsideThePolygon) {
  const Drawing drawing({"11111111", "11111111", "11....11", "11....11", "11111111", "11111111"});
  const auto polygons = drawing.polygons();
  const SurfacePolygon& surface = polygons.surfaces[0];
  const double spacing = 0.1 * kPixel;
  const auto points = sampleSurface(surface, spacing);
  EXPECT_NEAR(static_cast<double>(points.size()) * spacing * spacing, surface.area, 0.03 * surface.area);
  for (const Vector3& p : points) {
    EXPECT_NEAR(p.z(), 2.0, 1e-9);
    const double column = p.x() / kPixel + 3.0, row = p.y() / kPixel + 2.0;
    EXPECT_TRUE(column > -0.5001 && column < 7.5001 && row > -0.5001 && row < 5.5001) << column << ' ' << row;
    EXPECT_FALSE(column > 1.5001 && column < 5.4999 && row > 1.5001 && row < 3.4999) << column << ' ' << row;
    const Vector2 flat = surface.basis.flat(p) / spacing;
    EXPECT_NEAR(flat.x(), std::round(flat.x()), 1e-6);
    EXPECT_NEAR(flat.y(), std::round(flat.y()), 1e-6);
  }
  EXPECT_TRUE(sampleSurface(surface, 0.0).empty());
  EXPECT_TRUE(sampleSurface(surface, 1e-9).empty());
  EXPECT_TRUE(sampleSurface(surface, spacing, 10).empty());
}

TEST(SurfaceSampling, PointsOnTheirPlanes) {
  Drawing drawing({"11.", "11."});
  drawing.depth = {2.1f, 1.9f, 3.0f, 2.0f, 0.0f, 1.0f};
  for (const OutlinePlacement placement : {OutlinePlacement::Orthogonal, OutlinePlacement::AlongRay}) {
    const auto points = pointsOnPlanes(drawing.frame(), drawing.segmentation, placement);
    ASSERT_EQ(points.size(), 6U);
    EXPECT_FLOAT_EQ(points[0].z(), 2.0f);
    // Orthogonally a point keeps x, along its ray the pixel's place.
    EXPECT_FLOAT_EQ(points[0].x(), -0.03f * (placement == OutlinePlacement::AlongRay ? 2.0f : 2.1f));
    EXPECT_FLOAT_EQ(points[2].z(), 3.0f);
    EXPECT_TRUE(std::isnan(points[4].x()));
  }
}

}  // namespace
}  // namespace epcc
