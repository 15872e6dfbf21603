// SPDX-License-Identifier: BSD-3-Clause
// The lines of a laser scan, with their uncertainty.
#include <epcc_segmentation/laser_line_extractor.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

/// What a scanner sees of a room, 4 m by 3 m, in which a box hides a part of the wall ahead; every second range is 5 mm
/// too long, every other 5 mm too short.
epcc::LaserScan scanOfRoom() {
  constexpr double kDegree = 0.017453292519943295;
  epcc::LaserScan scan;
  scan.angle_min = 0.0;
  scan.angle_increment = kDegree;
  for (int beam = 0; beam < 360; ++beam) {
    const double c = std::cos(beam * kDegree), s = std::sin(beam * kDegree);
    double range = std::min(c > 0.0 ? 2.5 / c : -1.5 / c, s > 0.0 ? 1.8 / s : -1.2 / s);
    if (c > 0.0 && std::abs(1.5 * s / c) < 0.2) range = 1.5 / c;
    scan.ranges.push_back(range + (beam % 2 == 0 ? 0.005 : -0.005));
  }
  return scan;
}

int main() {
  // sigma_r = 5 mm at any range; epcc::estimateRangeNoise() measures it on scans.
  epcc::LaserLineExtractor extractor(epcc::SensorModel::polynomial(0.0, 0.0, 0.005));
  epcc::LaserLines result;
  if (!extractor.extract(scanOfRoom(), result)) {
    std::printf("%s\n", extractor.error().c_str());
    return 1;
  }
  for (const epcc::LaserLine& line : result.lines)
    std::printf("%3d points from (%5.2f %5.2f) to (%5.2f %5.2f), %.2f m away, sigma %.1f mm and %.1f mrad\n",
                line.points, line.start.x(), line.start.y(), line.end.x(), line.end.y(), line.rho,
                1e3 * std::sqrt(line.covariance(1, 1)), 1e3 * std::sqrt(line.covariance(0, 0)));
}

// Prints:
//    94 points from ( 2.50  1.80) to (-1.50  1.80), 1.80 m away, sigma 0.5 mm and 0.4 mrad
//    89 points from (-1.50  1.80) to (-1.50 -1.20), 1.50 m away, sigma 0.5 mm and 0.5 mrad
//   116 points from (-1.50 -1.20) to ( 2.50 -1.20), 1.20 m away, sigma 0.4 mm and 0.3 mrad
//    44 points from ( 2.50 -1.20) to ( 2.50  1.80), 2.50 m away, sigma 0.8 mm and 0.7 mrad
//    15 points from ( 1.50 -0.18) to ( 1.50  0.18), 1.50 m away, sigma 1.3 mm and 11.3 mrad
