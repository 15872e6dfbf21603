// SPDX-License-Identifier: BSD-3-Clause
// Laser scans of a floor plan with exact truth: which beam sees which wall, and where the part of it ends that is seen.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "datasets/files/laser_log.h"

namespace epcc {

/// A flat face: wall, door jamb, side of a box. Metres.
struct FloorFace {
  Vector2 from, to;
};

/// Something round that is no line.
struct FloorPillar {
  Vector2 centre;
  double radius;  ///< metres
};

struct FloorPlan {
  std::vector<FloorFace> faces;
  std::vector<FloorPillar> pillars;
};

/// Four rooms off a corridor, 14 m by 9 m, with doors, round and square pillars; a dozen boxes stand where the seed
/// puts them.
FloorPlan officeFloor(std::uint64_t seed);

/// A laser range finder.
struct LaserSensor {
  int beams = 720;
  double angle_min = 0.0;                         ///< rad
  double angle_increment = 0.008726646259971648;  ///< rad
  double range_max = 30.0;                        ///< metres
  double noise_a = 0.01, noise_b = 0.001;         ///< sigma_r = a + b r

  /// Half a degree all round, as above.
  static LaserSensor allRound() { return {}; }
  /// One degree over half a circle, as the scanners of the first logs.
  static LaserSensor halfCircle();
};

/// A face as one scan sees it, in the frame of the sensor.
struct SeenFace {
  int face = 0;            ///< of the plan
  std::vector<int> beams;  ///< that hit it, in the order along it
  /// Of what is seen, exact, not to the next beam. What hides its middle does not count, nor does what fewer than three
  /// beams in a row see of an end behind something.
  Vector2 start, end;
  double alpha = 0.0, rho = 0.0;
};

struct FloorScan {
  LaserRecord record;  ///< with noise
  std::vector<SeenFace> faces;
  std::vector<std::int32_t> labels;  ///< of each beam: 0 nothing flat, k the face faces[k - 1]
};

/// One scan from a pose.
FloorScan scanFloor(const FloorPlan& plan, const LaserSensor& sensor, const LaserPose& pose, std::uint64_t seed);

/// Scans along a path through the rooms, `count` of them, evenly spread.
std::vector<FloorScan> scanOffice(const LaserSensor& sensor, int count, std::uint64_t seed);

}  // namespace epcc
