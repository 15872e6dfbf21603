// SPDX-License-Identifier: BSD-3-Clause
// An ordered scan of a laser range finder in a plane, and the line segments that are found in it.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "epcc_segmentation/export.h"
#include "epcc_segmentation/vectors.h"

namespace epcc {

/// Ranges of consecutive beams from one place. The sensor is the origin, x is angle 0, angles grow from x to y.
/// NaN, what is not above `range_min`, what is not below `range_max`, and what no laser measures (below 0.1 mm, beyond
/// 10 000 km) count as no return.
struct LaserScan {
  std::vector<double> ranges;    ///< metres, in the order in which the beams lie side by side
  double angle_min = 0.0;        ///< of the first beam, rad
  double angle_increment = 0.0;  ///< from beam to beam, rad; negative for a scan that runs clockwise
  /// Of each beam, rad, in place of the two above; empty, or as many as ranges. Any spacing.
  std::vector<double> angles;
  double range_min = 0.0;                                      ///< metres
  double range_max = std::numeric_limits<double>::infinity();  ///< metres

  /// Of points (x, y) in the order in which they were measured, metres, seen from the origin. A point that is not
  /// finite is a beam without return.
  EPCC_CORE_EXPORT static LaserScan fromPoints(const std::vector<Vector2>& points);

  /// Direction of a beam, rad.
  double angle(std::size_t beam) const {
    return angles.empty() ? angle_min + angle_increment * static_cast<double>(beam) : angles[beam];
  }
  /// Whether a beam's range counts: above range_min, below range_max, and one that a laser can measure.
  bool hasReturn(std::size_t beam) const {
    constexpr double kLeast = 1e-4, kMost = 1e7;  // metres
    return ranges[beam] > range_min && ranges[beam] < range_max && ranges[beam] >= kLeast && ranges[beam] <= kMost;
  }
  /// Whether the beams go once round, so that the last is the first one's neighbour.
  EPCC_CORE_EXPORT bool isFullCircle() const;
};

/// A line segment of a scan: what beams see of the line x cos(alpha) + y sin(alpha) = rho.
struct LaserLine {
  int first = 0;   ///< the first beam that hit it, in the scan's order ...
  int last = 0;    ///< ... and the last; first > last where it passes the seam of a full circle
  int points = 0;  ///< beams that hit it; those between that see something else do not count
  /// Where the first beam meets the line (Eq. 21 along the beam), or the corner with the line before it; the sensor's
  /// frame, metres.
  Vector2 start = Vector2::Zero();
  Vector2 end = Vector2::Zero();         ///< the same of the last beam
  bool starts_in_corner = false;         ///< `start` is where this line and the one before it cross
  bool ends_in_corner = false;           ///< `end` is where this line and the next one cross
  double alpha = 0.0;                    ///< direction of the normal that points away from the sensor, rad, (-pi, pi]
  double rho = 0.0;                      ///< distance of the line from the sensor, metres, positive
  Matrix2 covariance = Matrix2::Zero();  ///< of (alpha, rho): rad^2, rad m, m^2
  /// Of `start`, m^2: that of the line where it is met, and along the line what lies between two beams, for the surface
  /// ends anywhere there; in a corner that of the crossing.
  Matrix2 start_covariance = Matrix2::Zero();
  Matrix2 end_covariance = Matrix2::Zero();  ///< the same of `end`
  double variance = 0.0;                     ///< of the points' distances from the line, m^2
  /// Squared range errors in units of the noise model, mean by degrees of freedom; 1 if both agree.
  double chi_squared = 0.0;

  /// From start to end, metres.
  double length() const { return (end - start).norm(); }
};

/// The lines of a scan.
struct LaserLines {
  std::vector<LaserLine> lines;      ///< in the order of their first beams
  std::vector<std::int32_t> labels;  ///< of each beam: 0 no line, k the line lines[k - 1]
};

}  // namespace epcc
