// SPDX-License-Identifier: BSD-3-Clause
// Edges: where two planes meet, as segments of the line that they have in common.
#pragma once

#include <vector>

#include "epcc_segmentation/depth_frame.h"
#include "epcc_segmentation/export.h"
#include "epcc_segmentation/plane_segmentation.h"
#include "epcc_segmentation/sensor_model.h"
#include "epcc_segmentation/vectors.h"

namespace epcc {

/// A part of the line that two planes have in common, where their regions touch in the image.
struct PlaneEdge {
  int first = 0;                    ///< label of one plane
  int second = 0;                   ///< label of the other, first < second
  Vector3 start = Vector3::Zero();  ///< metres, in the frame of the cloud; seen from the sensor `first` is to the left
  Vector3 end = Vector3::Zero();    ///< of the way from start to end
  double length = 0.0;              ///< metres
  /// Angle between the planes' normals, radians: 0 the surfaces go on straight, pi/2 a right angle, near pi a fold.
  double angle = 0.0;
  /// True for an edge that stands out to the sensor, as that of a box; false for a corner, as that of a room.
  bool convex = false;
  int pixels = 0;  ///< pixel sides along which the regions touch
  /// How far the regions' border in the image is off the line, root mean square, pixels.
  double offset = 0.0;
};

/// When two regions count as meeting.
struct EdgeOptions {
  /// Pixels without a label that may lie between the regions, along a row or a column. Raise it where borders are
  /// eaten away. Their points must not be off both planes. [0, 100]
  int max_gap = 3;
  /// The step in depth between the planes at the border, in standard deviations of the depth; what the planes differ by
  /// over `place_pixels` is allowed on top. Raise it if edges are missing, lower it if surfaces behind each other are
  /// joined. [0, 100]
  double max_step = 3.0;
  /// How exactly the border's place is known without noise, pixels. [0, 100]
  double place_pixels = 1.5;
  /// The border is never farther from the line than this, pixels. [0, 100]
  double max_offset = 8.0;
  /// Angle between the planes' normals below which there is no edge: their line is not well defined; radians. [0, pi/2]
  double min_angle = 0.14;
  /// Shorter contacts are none, pixel sides. [1, 1e9]
  int min_pixels = 6;
};

/// The edges of a segmentation alone, as surfacePolygons() gives them, in the order of (first, second); the pieces of
/// an edge in no particular order. Empty where that reports a problem.
EPCC_CORE_EXPORT std::vector<PlaneEdge> planeEdges(const DepthFrame& frame, const SensorModel& sensor,
                                                   const PlaneSegmentation& segmentation,
                                                   const EdgeOptions& options = EdgeOptions());

}  // namespace epcc
