// SPDX-License-Identifier: BSD-3-Clause
// Pixels become points, surfaces triangles and outlines; contours of the labels are laid into their planes.
#include "eval/view/view_scene.h"

#include <algorithm>
#include <cmath>

#include "epcc_segmentation/contours.h"
#include "eval/pictures/label_colors.h"

namespace epcc {
namespace {

constexpr std::size_t kShortestBorder = 12;  // pixels
constexpr double kBeforePoints = 0.002;      // of the distance from the sensor
constexpr double kGrazing = 1.0 / 3.0;       // cosine; flatter rays meet the plane far from where they were measured
constexpr double kDimmed = 0.35;

Rgb scaled(const Rgb& color, double factor) {
  const auto channel = [&](std::uint8_t value) { return static_cast<std::uint8_t>(std::lround(factor * value)); };
  return {channel(color.r), channel(color.g), channel(color.b)};
}

Rgb pointColor(std::int32_t label, const ViewStyle& style) {
  const Rgb color = label > 0 ? labelColor(label) : kUnlabelledColor;
  return style.selected == 0 || style.selected == label ? color : scaled(color, kDimmed);
}

/// Lines and arrows on points of the same colour would not be seen.
Rgb markColor(std::int32_t label, const ViewStyle& style) {
  if (style.selected == label) return {255, 255, 255};
  const Rgb color = pointColor(label, style);
  const auto lighter = [](std::uint8_t value) { return static_cast<std::uint8_t>(value + (255 - value) / 2); };
  return {lighter(color.r), lighter(color.g), lighter(color.b)};
}

ViewSensor sensorOf(const DepthFrame& frame) {
  const Eigen::Vector3d origin = frame.fromScan(Eigen::Vector3d::Zero());
  const auto direction = [&](const Eigen::Vector3d& axis) {
    return Eigen::Vector3d((frame.fromScan(axis) - origin).normalized());
  };
  return {origin, direction(Eigen::Vector3d::UnitZ()), direction(-Eigen::Vector3d::UnitY()),
          !isPerspective(frame.projection())};
}

std::vector<ViewPoint> pointsOf(const DepthFrame& frame, const PlaneSegmentation& result, const ViewStyle& style) {
  std::vector<ViewPoint> points;
  Eigen::Vector3d point;
  for (int row = 0; row < frame.height(); ++row)
    for (int column = 0; column < frame.width(); ++column) {
      const std::int32_t label = result.labels[frame.index(row, column)];
      if (label <= 0 && !style.unlabelled) continue;
      if (!frame.point(row, column, point)) continue;
      points.push_back({point.cast<float>(), pointColor(label, style), label});
    }
  return points;
}

/// The point on the plane, where the ray of its pixel meets it: seen from the sensor the border stays at its pixels.
Eigen::Vector3d onPlane(const Plane& plane, const Eigen::Vector3d& point, const Eigen::Vector3d& sensor) {
  const Eigen::Vector3d ray = (point - sensor).normalized();
  const double cosine = plane.coefficients.head<3>().dot(ray);
  if (std::abs(cosine) < kGrazing) return plane.project(point);
  return point - plane.signedDistance(point) / cosine * ray;
}

/// A little nearer to the sensor than the noise of the points, so that they do not hide it; where there are none, in
/// the plane itself.
Eigen::Vector3f beforePoints(const Eigen::Vector3d& in_plane, const Plane& plane, const ViewStyle& style,
                             const Eigen::Vector3d& sensor) {
  if (!style.points) return in_plane.cast<float>();
  const Eigen::Vector3d back = sensor - in_plane;
  const double before = kBeforePoints + std::min(0.05, 2.0 * plane.rms / back.norm());
  return (in_plane + before * back).cast<float>();
}

/// The border's pixels in space. The plane, and not the noise of single pixels, says where.
ViewOutline outlineOf(const DepthFrame& frame, const Plane& plane, const PixelContour& contour, const ViewStyle& style,
                      const Eigen::Vector3d& sensor) {
  ViewOutline outline;
  Eigen::Vector3d point;
  for (const Eigen::Vector2i& pixel : contour.points) {
    if (!frame.point(pixel.y(), pixel.x(), point)) continue;
    outline.points.push_back(beforePoints(onPlane(plane, point, sensor), plane, style, sensor));
  }
  return outline;
}

/// The rings of all pieces and of their holes.
std::vector<ViewOutline> polygonsOf(const FrameSurfaces& surfaces, const PlaneSegmentation& result,
                                    const ViewStyle& style, const Eigen::Vector3d& sensor) {
  std::vector<ViewOutline> outlines;
  for (const SurfacePolygon& surface : surfaces.polygons.surfaces) {
    const Plane& plane = result.planes[static_cast<std::size_t>(surface.label - 1)];
    const auto add = [&](const SurfaceRing& ring, bool is_hole) {
      ViewOutline outline{{}, markColor(surface.label, style), style.selected == surface.label, is_hole};
      for (const Vector3& point : ring.points) outline.points.push_back(beforePoints(point, plane, style, sensor));
      outlines.push_back(std::move(outline));
    };
    for (const SurfacePiece& piece : surface.pieces) {
      add(piece.outline, false);
      for (const SurfaceRing& hole : piece.holes) add(hole, true);
    }
  }
  return outlines;
}

std::vector<ViewTriangle> trianglesOf(const SurfaceMesh& mesh, const ViewStyle& style) {
  std::vector<ViewTriangle> triangles(mesh.triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k)
      triangles[i].corners[k] = mesh.vertices[static_cast<std::size_t>(mesh.triangles[i][k])].cast<float>();
    triangles[i].color = pointColor(mesh.labels[i], style);
  }
  return triangles;
}

std::vector<ViewOutline> contoursOf(const DepthFrame& frame, const PlaneSegmentation& result, const ViewStyle& style,
                                    const Eigen::Vector3d& sensor) {
  std::vector<ViewOutline> outlines;
  const int count = static_cast<int>(result.planes.size());
  const auto contours = traceAllContours(result.labels, result.width, result.height, count);
  for (std::size_t k = 0; k < contours.size(); ++k)
    for (const PixelContour& contour : contours[k]) {
      if (contour.points.size() < kShortestBorder) continue;
      const auto label = static_cast<std::int32_t>(k) + 1;
      outlines.push_back(outlineOf(frame, result.planes[k], contour, style, sensor));
      outlines.back().color = markColor(label, style);
      outlines.back().is_selected = style.selected == label;
    }
  return outlines;
}

/// Long enough to be seen on a large plane, and no longer than a small one is wide.
std::vector<ViewArrow> arrowsOf(const PlaneSegmentation& result, const ViewStyle& style) {
  std::vector<ViewArrow> arrows;
  for (std::size_t k = 0; k < result.planes.size(); ++k) {
    const Plane& plane = result.planes[k];
    const double length = 0.45 * std::sqrt(plane.points_covariance.trace());
    const Eigen::Vector3d tip = plane.centroid + length * plane.coefficients.head<3>();
    arrows.push_back(
        {plane.centroid.cast<float>(), tip.cast<float>(), markColor(static_cast<std::int32_t>(k) + 1, style)});
  }
  return arrows;
}

}  // namespace

ViewStyle firstStyle() {
  ViewStyle style;
  if (!surfacesMissing().empty()) style.outline_kind = OutlineKind::Contours;
  return style;
}

ViewScene viewScene(const DepthFrame& frame, const PlaneSegmentation& result, const FrameSurfaces& surfaces,
                    const ViewStyle& style) {
  ViewScene scene;
  scene.sensor = sensorOf(frame);
  scene.points = pointsOf(frame, result, style);
  scene.draws_points = style.points;
  if (style.mesh) scene.triangles = trianglesOf(surfaces.mesh, style);
  if (style.outlines)
    scene.outlines = style.outline_kind == OutlineKind::Polygons
                         ? polygonsOf(surfaces, result, style, scene.sensor.origin)
                         : contoursOf(frame, result, style, scene.sensor.origin);
  if (style.normals) scene.arrows = arrowsOf(result, style);
  return scene;
}

}  // namespace epcc
