// SPDX-License-Identifier: BSD-3-Clause
// A scanner whose rings look at different azimuths, for tests of streams: its columns and the clouds they make.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "epcc_segmentation/scan_line_stream.h"
#include "tests/support/spinning_scanner.h"

namespace epcc::test {

inline const SensorModel kStaggeredSensor = SensorModel::axial(0.004, 0.0);

inline StreamOptions staggeredOptions(int lines_at_once = 32) {
  StreamOptions options;
  options.sensor = kStaggeredSensor;
  options.lines_at_once = lines_at_once;
  return options;
}

/// Four offsets over and over, as many scanners have, in steps of the azimuth; `part` of a step more on every other.
inline SpinningScanner staggeredScanner(double noise = 0.004, double part = 0.3) {
  SpinningScanner scanner;
  scanner.noise = noise;
  const double steps[] = {6.0, 2.0, -2.0, -7.0};
  for (int ring = 0; ring < scanner.rings; ++ring)
    scanner.ring_azimuths.push_back((steps[ring % 4] + (ring % 2 == 0 ? part : -part)) * scanner.azimuthStep());
  return scanner;
}

inline std::vector<std::vector<float>> columnsOf(const SpinningScanner& scanner, int columns, unsigned seed = 3) {
  std::mt19937 random(seed);
  std::vector<std::vector<float>> result;
  for (int column = 0; column < columns; ++column) result.push_back(scanner.ranges(column, random));
  return result;
}

/// The shifts of a geometry.
struct RingShifts {
  explicit RingShifts(const StreamGeometry& geometry) {
    for (int ring = 0; ring < geometry.height(); ++ring) of.push_back(geometry.ringShift(ring));
    least = *std::min_element(of.begin(), of.end());
    most = *std::max_element(of.begin(), of.end());
  }
  std::vector<int> of;
  int least = 0, most = 0;
};

/// Ring `ring` of a column as a point: x forward, y left, z up; NaN where nothing is measured.
inline void pointOf(const SpinningScanner& scanner, int column, std::size_t ring, float range, float* xyz) {
  const double elevation = scanner.elevations()[ring];
  const double azimuth = scanner.azimuth(column) + scanner.ringAzimuth(ring);
  xyz[0] = static_cast<float>(range * std::cos(elevation) * std::cos(azimuth));
  xyz[1] = static_cast<float>(range * std::cos(elevation) * std::sin(azimuth));
  xyz[2] = static_cast<float>(range * std::sin(elevation));
}

/// The columns as a cloud, row by row: as they came, or (`aligned`) by scan lines, which are more.
inline std::vector<float> cloudOf(const SpinningScanner& scanner, const std::vector<std::vector<float>>& columns,
                                  bool aligned) {
  const RingShifts shifts(scanner.geometry());
  const int count = static_cast<int>(columns.size());
  const int width = aligned ? count + shifts.most - shifts.least : count;
  std::vector<float> xyz(static_cast<std::size_t>(3 * scanner.rings * width), NAN);
  for (int ring = 0; ring < scanner.rings; ++ring)
    for (int column = 0; column < count; ++column) {
      const auto r = static_cast<std::size_t>(ring);
      const int line = aligned ? column - shifts.of[r] + shifts.most : column;
      pointOf(scanner, column, r, columns[static_cast<std::size_t>(column)][r], xyz.data() + 3 * (ring * width + line));
    }
  return xyz;
}

inline void addAll(const SpinningScanner& scanner, const std::vector<std::vector<float>>& columns,
                   ScanLineStream& stream, bool at_azimuths = false) {
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const auto column = static_cast<std::int64_t>(i);
    const double azimuth = scanner.azimuth(column);
    ASSERT_TRUE(at_azimuths ? stream.addColumnAt(azimuth, columns[i].data())
                            : stream.addColumn(column, azimuth, columns[i].data()))
        << stream.error();
  }
  ASSERT_TRUE(stream.finish()) << stream.error();
}

}  // namespace epcc::test
