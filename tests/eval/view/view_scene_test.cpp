// SPDX-License-Identifier: BSD-3-Clause
// What is shown of a room's corner: points and their colours, outlines and mesh in the planes, normals that face the
// sensor.
#include "eval/view/view_scene.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <set>

#include "epcc_segmentation/plane_extractor.h"
#include "eval/pictures/label_colors.h"
#include "tests/eval/view/need_surfaces.h"
#include "tests/support/tiny_frames.h"

namespace epcc {
namespace {

bool operator==(const Rgb& a, const Rgb& b) {
  return a.r == b.r && a.g == b.g && a.b == b.b;
}

class ViewSceneTest : public ::testing::Test {
 protected:
  ViewSceneTest() : frame_(test::tinyFrame("room", 1)) {
    for (int column = 0; column < 5; ++column) frame_.depth.at(20, 30 + column) = 0.0F;  // not measured
    PlaneExtractor extractor(Parameters(), sensor_);
    EXPECT_TRUE(extractor.extract(frameView(frame_), result_)) << extractor.error();
    EXPECT_EQ(result_.planes.size(), 3U);
    for (int row = 0; row < 4; ++row)  // on no plane
      for (int column = 0; column < 4; ++column) result_.labels[static_cast<std::size_t>(80 * row + column)] = 0;
  }
  ViewScene scene(const ViewStyle& style = firstStyle()) const {
    FrameSurfaces surfaces;
    if (style.needsSurfaces()) surfaces = frameSurfaces(frameView(frame_), sensor_, result_, true);
    return viewScene(frameView(frame_), result_, surfaces, style);
  }
  static ViewStyle contours() {
    ViewStyle style;
    style.outline_kind = OutlineKind::Contours;
    return style;
  }
  /// Leaves a rectangle in the middle of the largest plane unmeasured.
  void cutAHole() {
    for (int row = 0; row < 60; ++row)
      for (int column = 0; column < 80; ++column) {
        if (std::abs(row - hole_.y()) > 5 || std::abs(column - hole_.x()) > 6) continue;
        frame_.depth.at(row, column) = 0.0F;
        result_.labels[static_cast<std::size_t>(80 * row + column)] = 0;
      }
  }
  /// The pixel (column, row) of a point.
  Eigen::Vector2d pixelOf(const Eigen::Vector3f& point) const {
    const PinholeCamera& camera = frame_.camera.camera;
    return {point.x() / point.z() * camera.fx + camera.cx, point.y() / point.z() * camera.fy + camera.cy};
  }

  SensorModel sensor_ = SensorModel::axial(0.0005, 0.0005);
  LabelledFrame frame_;
  PlaneSegmentation result_;
  Eigen::Vector2i hole_{22, 34};  // column and row, on the back wall
};

TEST_F(ViewSceneTest, EveryMeasuredPixelIsAPointInThePlanesColour) {
  const ViewScene all = scene();
  ASSERT_EQ(all.points.size(), 80U * 60U - 5U);
  std::size_t grey = 0;
  for (const ViewPoint& point : all.points) {
    const Rgb wanted = point.label > 0 ? labelColor(point.label) : kUnlabelledColor;
    EXPECT_TRUE(point.color == wanted);
    if (point.label == 0) ++grey;
    if (point.label > 0) {
      const Plane& plane = result_.planes[static_cast<std::size_t>(point.label - 1)];
      EXPECT_LT(std::abs(plane.signedDistance(point.position.cast<double>())), 0.05);
    }
  }
  EXPECT_GE(grey, 16U);
}

TEST_F(ViewSceneTest, PointsOnNoPlaneCanBeHidden) {
  ViewStyle style;
  style.unlabelled = false;
  const ViewScene shown = scene(style);
  EXPECT_LE(shown.points.size(), 80U * 60U - 5U - 16U);
  for (const ViewPoint& point : shown.points) EXPECT_GT(point.label, 0);
}

TEST_F(ViewSceneTest, ContoursLieInThePlanesBeforeThePoints) {
  const ViewScene shown = scene(contours());
  ASSERT_GE(shown.outlines.size(), 3U);
  for (const ViewOutline& outline : shown.outlines) {
    EXPECT_GE(outline.points.size(), 12U);
    // One of the planes holds all of the border, but for the little that it is moved to the sensor.
    double best = 1e9;
    for (const Plane& plane : result_.planes) {
      double farthest = 0.0;
      for (const Eigen::Vector3f& point : outline.points)
        farthest = std::max(farthest, std::abs(plane.signedDistance(point.cast<double>())));
      best = std::min(best, farthest);
    }
    EXPECT_LT(best, 0.02);
  }
  ViewStyle style;
  style.outlines = false;
  EXPECT_TRUE(scene(style).outlines.empty());
}

TEST_F(ViewSceneTest, SeenFromTheSensorContoursStayAtTheirPixels) {
  std::size_t borders = 0, near = 0;
  for (const ViewOutline& outline : scene(contours()).outlines)
    for (const Eigen::Vector3f& point : outline.points) {
      const Eigen::Vector2d pixel = pixelOf(point);
      ++borders;
      if ((pixel - Eigen::Vector2d(std::round(pixel.x()), std::round(pixel.y()))).norm() < 0.01) ++near;
    }
  EXPECT_GT(near, borders * 9 / 10);
}

TEST_F(ViewSceneTest, PolygonsAreDrawnWithTheirHoles) {
  EPCC_NEED_SURFACES();
  const std::size_t without = scene().outlines.size();
  cutAHole();
  ViewStyle style = firstStyle();
  style.points = false;
  const ViewScene shown = scene(style);
  EXPECT_FALSE(shown.draws_points);
  ASSERT_EQ(shown.outlines.size(), without + 1);
  std::size_t holes = 0;
  for (const ViewOutline& outline : shown.outlines) {
    double best = 1e9, away = 0.0;
    for (const Plane& plane : result_.planes) {
      double farthest = 0.0;
      for (const Eigen::Vector3f& point : outline.points)
        farthest = std::max(farthest, std::abs(plane.signedDistance(point.cast<double>())));
      best = std::min(best, farthest);
    }
    EXPECT_LT(best, 1e-5) << "without points before them they lie in the plane itself";
    for (const Eigen::Vector3f& point : outline.points)
      away = std::max(away, (pixelOf(point) - hole_.cast<double>()).cwiseAbs().maxCoeff());
    if (away < 8.0) ++holes;
  }
  EXPECT_EQ(holes, 1U);
}

TEST_F(ViewSceneTest, OutlinesOfPolygonsAreBeforeThePointsOnly) {
  EPCC_NEED_SURFACES();
  ViewStyle style = firstStyle();
  const ViewScene before = scene(style);
  style.points = false;
  const ViewScene in_plane = scene(style);
  ASSERT_EQ(before.outlines.size(), in_plane.outlines.size());
  for (std::size_t i = 0; i < before.outlines.size(); ++i)
    for (std::size_t k = 0; k < before.outlines[i].points.size(); ++k) {
      const Eigen::Vector3f &near = before.outlines[i].points[k], &on = in_plane.outlines[i].points[k];
      EXPECT_LT(near.norm(), 0.999F * on.norm());
      EXPECT_LT((near.normalized() - on.normalized()).norm(), 1e-5F) << "along the ray";
    }
}

TEST_F(ViewSceneTest, TheMeshCoversThePlanesInTheirColoursButNotTheHole) {
  EPCC_NEED_SURFACES();
  cutAHole();
  ViewStyle style = firstStyle();
  EXPECT_TRUE(scene(style).triangles.empty());
  style.mesh = true;
  const ViewScene shown = scene(style);
  const SurfacePolygons polygons = frameSurfaces(frameView(frame_), sensor_, result_, false).polygons;
  std::vector<double> area(polygons.surfaces.size(), 0.0);
  for (const ViewTriangle& triangle : shown.triangles) {
    std::size_t on = 0;
    for (std::size_t k = 0; k < area.size(); ++k)
      if (labelColor(static_cast<std::int32_t>(k) + 1) == triangle.color) on = k;
    const Eigen::Vector3f a = triangle.corners[1] - triangle.corners[0], b = triangle.corners[2] - triangle.corners[0];
    area[on] += 0.5 * static_cast<double>(a.cross(b).norm());
    for (const Eigen::Vector3f& corner : triangle.corners)
      EXPECT_LT(std::abs(result_.planes[on].signedDistance(corner.cast<double>())), 1e-5);
    const Eigen::Vector3f middle = (triangle.corners[0] + triangle.corners[1] + triangle.corners[2]) / 3.0F;
    EXPECT_GT((pixelOf(middle) - hole_.cast<double>()).cwiseAbs().maxCoeff(), 4.0) << "in the hole";
  }
  for (std::size_t k = 0; k < area.size(); ++k)
    EXPECT_NEAR(area[k], polygons.surfaces[k].area, 1e-4 * polygons.surfaces[k].area) << k;
  style.selected = 2;
  for (const ViewTriangle& triangle : scene(style).triangles)
    for (const std::int32_t dimmed : {1, 3}) EXPECT_FALSE(triangle.color == labelColor(dimmed));
}

TEST_F(ViewSceneTest, WithoutSurfacesOutlinesAreContoursFromTheStart) {
  EXPECT_EQ(firstStyle().outline_kind == OutlineKind::Polygons, surfacesMissing().empty());
  EXPECT_FALSE(contours().needsSurfaces());
}

TEST_F(ViewSceneTest, ArrowsAreNormalsThatFaceTheSensor) {
  const ViewScene shown = scene();
  ASSERT_EQ(shown.arrows.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    const Eigen::Vector3d from = shown.arrows[i].from.cast<double>(), to = shown.arrows[i].to.cast<double>();
    EXPECT_NEAR((from - result_.planes[i].centroid).norm(), 0.0, 1e-6);
    EXPECT_NEAR((to - from).normalized().dot(result_.planes[i].coefficients.head<3>()), 1.0, 1e-5);
    EXPECT_GT((to - from).dot(shown.sensor.origin - from), 0.0);
  }
  ViewStyle style;
  style.normals = false;
  EXPECT_TRUE(scene(style).arrows.empty());
}

TEST_F(ViewSceneTest, TheSelectedPlaneStandsOut) {
  ViewStyle style = firstStyle();
  style.selected = 2;
  for (const ViewPoint& point : scene(style).points) {
    const Rgb plain = point.label > 0 ? labelColor(point.label) : kUnlabelledColor;
    if (point.label == 2)
      EXPECT_TRUE(point.color == plain);
    else
      EXPECT_LT(point.color.r + point.color.g + point.color.b, (plain.r + plain.g + plain.b) / 2);
  }
  std::size_t selected = 0;
  for (const ViewOutline& outline : scene(style).outlines)
    if (outline.is_selected) {
      ++selected;
      EXPECT_TRUE(outline.color == (Rgb{255, 255, 255}));
    }
  EXPECT_GE(selected, 1U);
}

TEST_F(ViewSceneTest, TheSensorOfACameraLooksAlongZWithYDown) {
  const ViewSensor sensor = scene().sensor;
  EXPECT_FALSE(sensor.is_scanner);
  EXPECT_NEAR(sensor.forward.z(), 1.0, 1e-9);
  EXPECT_NEAR(sensor.up.y(), -1.0, 1e-9);
}

TEST(ViewSceneOfAScan, TheSensorLooksAlongXWithZUp) {
  std::vector<float> xyz;
  for (int row = 0; row < 16; ++row)
    for (int column = 0; column < 90; ++column) {
      const double azimuth = -4.0 * column * M_PI / 180.0, elevation = (8.0 - row) * M_PI / 180.0;
      for (const double value : {5.0 * std::cos(elevation) * std::cos(azimuth),
                                 5.0 * std::cos(elevation) * std::sin(azimuth), 5.0 * std::sin(elevation)})
        xyz.push_back(static_cast<float>(value));
    }
  PlaneSegmentation nothing;
  nothing.width = 90;
  nothing.height = 16;
  nothing.labels.assign(90 * 16, 0);
  const ViewScene scene =
      viewScene(DepthFrame::fromPoints(xyz.data(), 3, 90, 16, Projection::Spherical), nothing, {}, ViewStyle());
  EXPECT_TRUE(scene.sensor.is_scanner);
  EXPECT_NEAR(scene.sensor.forward.x(), 1.0, 1e-9);
  EXPECT_NEAR(scene.sensor.up.z(), 1.0, 1e-9);
  EXPECT_EQ(scene.points.size(), 90U * 16U);
}

}  // namespace
}  // namespace epcc
