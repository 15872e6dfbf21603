// SPDX-License-Identifier: BSD-3-Clause
// Scans of a few lines, made beam by beam.
#pragma once

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "epcc_segmentation/laser_scan.h"

namespace epcc::test {

constexpr double kDegree = 0.017453292519943295;

struct Wall {
  Vector2 from, to;
};

/// What `beams` beams see of walls; no return where there is none.
inline LaserScan scanOf(const std::vector<Wall>& walls, int beams, double angle_min, double increment,
                        double sigma = 0.0, unsigned seed = 1) {
  LaserScan scan;
  scan.angle_min = angle_min;
  scan.angle_increment = increment;
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  for (int beam = 0; beam < beams; ++beam) {
    const double angle = scan.angle(static_cast<std::size_t>(beam));
    const Vector2 d(std::cos(angle), std::sin(angle));
    double range = std::numeric_limits<double>::infinity();
    for (const Wall& wall : walls) {
      const Vector2 side = wall.to - wall.from;
      const double turn = d.x() * side.y() - d.y() * side.x();
      const double r = (wall.from.x() * side.y() - wall.from.y() * side.x()) / turn;
      const double t = (wall.from.x() * d.y() - wall.from.y() * d.x()) / turn;
      if (r > 0.0 && r < range && t >= 0.0 && t <= 1.0) range = r;
    }
    scan.ranges.push_back(range + sigma * normal(random));
  }
  return scan;
}

/// A room around the sensor.
inline std::vector<Wall> room(double left, double right, double bottom, double top) {
  return {{{right, bottom}, {right, top}},
          {{right, top}, {left, top}},
          {{left, top}, {left, bottom}},
          {{left, bottom}, {right, bottom}}};
}

}  // namespace epcc::test
