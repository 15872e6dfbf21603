// SPDX-License-Identifier: BSD-3-Clause
// A spinning scanner in a room, for tests of streams: rings, columns and their ranges.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "epcc_segmentation/stream_geometry.h"

namespace epcc::test {

/// `rings` from 15 degrees up to `lowest` degrees down, `columns` a turn, clockwise as most do. It stands 1.5 m above
/// the floor of a room of 8 x 6 m, whose walls are `height` metres high; what is above them is open sky.
struct SpinningScanner {
  int rings = 32;
  int columns = 720;
  double lowest = 25.0;
  double wall_height = 3.0;
  double noise = 0.0;                 // metres, white
  double heading = 0.0;               // it looks to the left of the room's x axis by that, radians
  std::vector<double> ring_azimuths;  // to the left of the column's, radians; empty: rings are not staggered

  std::vector<double> elevations() const {
    std::vector<double> result;
    for (int i = 0; i < rings; ++i) result.push_back((15.0 - (15.0 + lowest) * i / (rings - 1)) * M_PI / 180.0);
    return result;
  }
  double azimuthStep() const { return -2.0 * M_PI / columns; }
  double azimuth(std::int64_t index) const {
    return std::remainder(static_cast<double>(index % columns) * azimuthStep(), 2.0 * M_PI);
  }
  StreamGeometry geometry() const { return StreamGeometry::scanner(elevations(), azimuthStep(), ring_azimuths); }
  double ringAzimuth(std::size_t ring) const { return ring_azimuths.empty() ? 0.0 : ring_azimuths[ring]; }

  /// Of one column, NaN where nothing is hit.
  std::vector<float> ranges(std::int64_t index, std::mt19937& random) const {
    std::normal_distribution<double> normal;
    std::vector<float> result;
    for (const double elevation : elevations()) {
      const double towards = heading + azimuth(index) + ringAzimuth(result.size());
      const double ahead = std::cos(towards), left = std::sin(towards);
      const double level = std::cos(elevation), up = std::sin(elevation);
      const double wall = 1.0 / std::max({ahead / 5.0, -ahead / 3.0, left / 2.5, -left / 3.5, 1e-9}) / level;
      const double floor = up < 0.0 ? -1.5 / up : 1e9;
      const double range = std::min(wall, floor) + noise * normal(random);
      const bool sky = wall < floor && wall * up > wall_height - 1.5;
      result.push_back(sky ? NAN : static_cast<float>(range));
    }
    return result;
  }
};

}  // namespace epcc::test
