// SPDX-License-Identifier: BSD-3-Clause
// What is shown of a segmented frame, as points, lines and arrows with their colours; nothing here draws.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "datasets/files/image.h"
#include "epcc_segmentation/depth_frame.h"
#include "epcc_segmentation/plane_segmentation.h"

namespace epcc {

/// What a person has chosen to see.
struct ViewStyle {
  bool outlines = true;
  bool normals = true;
  bool unlabelled = true;  ///< points on no plane
  int selected = 0;        ///< a plane that stands out, the others are dimmed; 0: none
};

/// A measured point. Lengths are metres, coordinates those of the frame (DepthFrame::point()).
struct ViewPoint {
  Eigen::Vector3f position;
  Rgb color;
  std::int32_t label = 0;
};

/// A border of a plane, closed, in the plane and a little before the points.
struct ViewOutline {
  std::vector<Eigen::Vector3f> points;
  Rgb color;
  bool is_selected = false;
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
  std::vector<ViewPoint> points;
  std::vector<ViewOutline> outlines;
  std::vector<ViewArrow> arrows;
  ViewSensor sensor;
};

/// Grey of the points on no plane, and the background.
constexpr Rgb kUnlabelledColor{110, 110, 110};
constexpr Rgb kBackgroundColor{18, 20, 26};

/// Points of plane k have labelColor(k), as in all pictures. Borders of fewer than 12 pixels are left out: single
/// pixels that were not measured would hide the rest. `result` is that of `frame`.
ViewScene viewScene(const DepthFrame& frame, const PlaneSegmentation& result, const ViewStyle& style);

}  // namespace epcc
