// SPDX-License-Identifier: BSD-3-Clause
// What a person wants to know of each plane: size, distance, tilt, roughness.
#pragma once

#include <string>
#include <vector>

#include "epcc_segmentation/depth_frame.h"
#include "epcc_segmentation/plane_segmentation.h"

namespace epcc {

/// One line of the report.
struct PlaneSummary {
  int id = 0;
  std::size_t pixels = 0;
  /// Visible area in square metres, approximate: holes and the outline count by whole pixels.
  double area = 0.0;
  /// Distance of the (infinite) plane from the sensor, metres.
  double distance = 0.0;
  /// Distance of the centroid of the visible part from the sensor, metres.
  double centroid_distance = 0.0;
  /// Angle between the plane and the sensor's horizontal plane, degrees: 0 lies, 90 stands.
  double tilt = 0.0;
  /// "floor-like", "ceiling-like", "wall-like" or "slanted", as seen by a sensor that is held level.
  std::string kind;
  /// Root mean square distance of the points from the plane, metres.
  double rms = 0.0;
  double confidence = 1.0;  ///< Plane::confidence
};

/// Summaries in the order of result.planes. `frame` is the frame that was segmented.
std::vector<PlaneSummary> summarizePlanes(const DepthFrame& frame, const PlaneSegmentation& result);

/// The summaries as a text table, one line a plane, each line starting with `indent`.
std::string planeTable(const std::vector<PlaneSummary>& planes, const std::string& indent = "");

}  // namespace epcc
