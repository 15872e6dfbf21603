// SPDX-License-Identifier: BSD-3-Clause
// What is shown of a segmented frame, as points, lines and arrows with their colours; nothing here draws.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "datasets/files/image.h"
#include "epcc_segmentation/depth_frame.h"
#include "epcc_segmentation/plane_segmentation.h"
#include "eval/segment/frame_surfaces.h"

namespace epcc {

/// What the outlines of planes are.
enum class OutlineKind {
  Polygons,  ///< of the surfaces, with holes: simplified within the noise, joined along the edges of neighbours
  Contours   ///< the outermost pixels of the label image
};

/// What a person has chosen to see.
struct ViewStyle {
  bool points = true;
  bool mesh = false;
  bool outlines = true;
  OutlineKind outline_kind = OutlineKind::Polygons;
  bool normals = true;
  bool unlabelled = true;  ///< points on no plane
  int selected = 0;        ///< a plane that stands out, the others are dimmed; 0: none

  /// Whether polygons have to be found for it.
  bool needsSurfaces() const { return mesh || (outlines && outline_kind == OutlineKind::Polygons); }
};

/// Points, outlines and normals. In a build without polygons outlines are contours.
ViewStyle firstStyle();

/// A measured point. Lengths are metres, coordinates those of the frame (DepthFrame::point()).
struct ViewPoint {
  Eigen::Vector3f position;
  Rgb color;
  std::int32_t label = 0;
};

/// A border of a plane, or of a hole in it: closed, in the plane, and a little before the points where there are any.
struct ViewOutline {
  std::vector<Eigen::Vector3f> points;
  Rgb color;
  bool is_selected = false;
  bool is_hole = false;  ///< of a polygon
};

/// One of a mesh.
struct ViewTriangle {
  std::array<Eigen::Vector3f, 3> corners;
  Rgb color;
};

/// The normal at a plane's centroid.
struct ViewArrow {
  Eigen::Vector3f from, to;
  Rgb color;
};

/// Where the sensor is, in the frame's coordinates.
struct ViewSensor {
  Eigen::Vector3d origin, forward, up;
  bool is_scanner = false;
};

/// All that is drawn but the texts.
struct ViewScene {
  std::vector<ViewPoint> points;  ///< also those that are not drawn: a view is chosen by them, and a plane
  bool draws_points = true;
  std::vector<ViewTriangle> triangles;
  std::vector<ViewOutline> outlines;
  std::vector<ViewArrow> arrows;
  ViewSensor sensor;
};

/// Grey of the points on no plane, and the background.
constexpr Rgb kUnlabelledColor{110, 110, 110};
constexpr Rgb kBackgroundColor{18, 20, 26};

/// Points and triangles of plane k have labelColor(k), as in all pictures. Contours of fewer than 12 pixels are left
/// out: single pixels that were not measured would hide the rest. `result` is that of `frame`, and `surfaces` are those
/// of both; they may be empty unless style.needsSurfaces().
ViewScene viewScene(const DepthFrame& frame, const PlaneSegmentation& result, const FrameSurfaces& surfaces,
                    const ViewStyle& style);

}  // namespace epcc
