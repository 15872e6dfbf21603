// SPDX-License-Identifier: BSD-3-Clause
// The surfaces of a segmentation as polygons with holes on their planes (Sec. 6, Fig. 19), neighbours joined at edges.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "epcc_segmentation/depth_frame.h"
#include "epcc_segmentation/export.h"
#include "epcc_segmentation/plane_edges.h"
#include "epcc_segmentation/plane_segmentation.h"
#include "epcc_segmentation/sensor_model.h"
#include "epcc_segmentation/status.h"
#include "epcc_segmentation/vectors.h"

namespace epcc {

/// Coordinates on a plane: p = origin + x * across + y * up, metres, in the frame of the cloud.
///
/// (across, up, normal) is a right-handed orthonormal triple, and the normal points to the sensor: what is
/// counter-clockwise in (x, y) is so for the sensor. `across` is horizontal for a sensor that is held level, to its
/// right; on a plane that lies (floor, ceiling, a normal within 11 degrees of the sensor's vertical) it is the sensor's
/// right-hand side itself, laid onto the plane. The origin is the plane's centroid, put onto the plane (Eq. 28).
struct PlaneBasis {
  Vector3 origin = Vector3::Zero();   ///< the plane's centroid, on the plane; metres
  Vector3 across = Vector3::UnitX();  ///< unit vector to the sensor's right
  Vector3 up = Vector3::UnitY();      ///< unit vector, across turned by 90 degrees counter-clockwise for the sensor
  Vector3 normal = Vector3::UnitZ();  ///< unit vector towards the sensor

  /// Coordinates (x, y) of the foot of a point on the plane, metres.
  Vector2 flat(const Eigen::Vector3d& point) const {
    const Eigen::Vector3d from_origin = point - origin;
    return {across.dot(from_origin), up.dot(from_origin)};
  }
  /// The point of the plane with these coordinates, metres, in the frame of the cloud.
  Vector3 point(const Eigen::Vector2d& flat) const { return origin + flat.x() * across + flat.y() * up; }
};

/// The basis of a plane that `frame` was segmented into.
EPCC_CORE_EXPORT PlaneBasis planeBasis(const DepthFrame& frame, const Plane& plane);

/// A closed line on a plane; the last point and the first are joined, too. No point comes twice.
struct SurfaceRing {
  std::vector<Vector3> points;  ///< metres, in the frame of the cloud
  std::vector<Vector2> flat;    ///< the same in the plane's basis

  /// Square metres; negative of a hole, which runs clockwise.
  double signedArea() const {
    double twice = 0.0;
    for (std::size_t i = 2; i < flat.size(); ++i) {
      const Vector2 a = flat[i - 1] - flat[0], b = flat[i] - flat[0];
      twice += a.x() * b.y() - a.y() * b.x();
    }
    return 0.5 * twice;
  }
};

/// One connected part of a surface: its outline, counter-clockwise for the sensor, and its holes, clockwise.
struct SurfacePiece {
  SurfaceRing outline;             ///< counter-clockwise for the sensor
  std::vector<SurfaceRing> holes;  ///< clockwise for the sensor, each inside the outline
};

/// The smallest rectangle, however it is turned, that holds all pieces of a surface.
struct OrientedExtent {
  Vector3 center = Vector3::Zero();       ///< on the plane, metres, in the frame of the cloud
  Vector3 long_axis = Vector3::UnitX();   ///< unit vector along the longer side
  Vector3 short_axis = Vector3::UnitY();  ///< long_axis turned by 90 degrees counter-clockwise for the sensor
  double length = 0.0;                    ///< metres, along long_axis
  double width = 0.0;                     ///< metres, along short_axis
};

/// A surface. Its pieces touch each other in single points at most; where the region leaves nothing with an inside
/// there are none.
struct SurfacePolygon {
  int label = 0;                     ///< the surface is planes[label - 1]
  PlaneBasis basis;                  ///< coordinates on its plane
  std::vector<SurfacePiece> pieces;  ///< the largest first
  double area = 0.0;                 ///< of the pieces without their holes, square metres
  double perimeter = 0.0;            ///< of outlines and holes, metres
  OrientedExtent extent;             ///< how long and wide it is
  /// What the region's pixels cover of the plane, square metres: the sum of their footprints, each as large as the
  /// pixel is, half a pixel beyond its centre to all sides.
  double pixel_area = 0.0;
  /// True if the outline crossed itself once it was on the plane and GEOS has mended it (MakeValid). Its points may
  /// then differ from those of the neighbours' outlines.
  bool is_mended = false;
};

/// How the outline's points are put onto the plane.
enum class OutlinePlacement {
  AlongRay,   ///< where the pixel's ray meets the plane: the outline covers the picture exactly as the region does
  Orthogonal  ///< Eq. 28: the measured points of the outline's pixels, each at its foot on the plane
};

/// How outlines are drawn. The defaults suit all sensors whose model is known.
struct PolygonOptions {
  /// How points are put onto the plane. AlongRay | Orthogonal, default AlongRay. Choose Orthogonal to stay with the
  /// paper.
  OutlinePlacement placement = OutlinePlacement::AlongRay;
  /// How far the pixels' own edges may be to either side of the outline, pixels. Raise it for fewer points; below 0.71
  /// the steps of slanted borders stay; 0: each pixel's edge is drawn. [0, 100]
  double tolerance_pixels = 0.75;
  /// The same for the noise: this many standard deviations of the depth, as long as they are on the plane, come on top
  /// (together never more than four times tolerance_pixels). Raise it for fewer points with a noisy sensor. [0, 100]
  double tolerance_sigma = 0.5;
  /// The largest share of a surface's area that drawing it simpler may add or take away, one half by other lines, where
  /// the tolerance is halved until it is kept, the other by rings that are left out. [0, 1]
  double max_area_change = 0.008;
  /// Pieces and holes of fewer pixels are left out (holes: filled), the smallest first, as long as max_area_change
  /// allows. Raise it, and max_area_change, to fill the holes of a sensor that leaves pixels out. [0, 1e9]
  int min_ring_pixels = 4;
  /// Borders of two surfaces that meet are moved onto their planes' common line, so that both have the same points
  /// there and a mesh is closed. Off: each border is as the pixels have it.
  bool close_edges = true;
  /// When two surfaces meet; read with close_edges, and for SurfacePolygons::edges.
  EdgeOptions edges;

  /// Empty if every value is in its range, else the first thing that is wrong, in words.
  EPCC_CORE_EXPORT std::string validate() const;
};

/// All surfaces of a frame.
struct SurfacePolygons {
  Status status = Status::Ok;            ///< Ok, or why there are no surfaces
  std::string problem;                   ///< the same in words; empty if nothing is wrong
  std::vector<SurfacePolygon> surfaces;  ///< one for each plane, in their order
  std::vector<PlaneEdge> edges;          ///< where they meet
};

/// The polygons of all planes of a segmentation, along the outer edges of their pixels, simplified within the noise and
/// valid (no line crosses itself or another, holes are inside). Frame and segmentation belong together: `frame` is what
/// was segmented, a depth image, a cloud of any frame, or a scan (which may close round: a floor round a scanner is one
/// ring). `sensor` is the model that it was segmented with (PlaneExtractor::sensor()).
///
/// Time and memory are about proportional to the pixels and to the length of the borders. Nothing is thrown: if frame
/// and segmentation do not fit each other, options are out of their range or memory runs out, `status` and `problem`
/// say so and there are no surfaces.
EPCC_CORE_EXPORT SurfacePolygons surfacePolygons(const DepthFrame& frame, const SensorModel& sensor,
                                                 const PlaneSegmentation& segmentation,
                                                 const PolygonOptions& options = PolygonOptions());

}  // namespace epcc
