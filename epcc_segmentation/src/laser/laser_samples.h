// SPDX-License-Identifier: BSD-3-Clause
// The returns of a scan, in an order in which no line is cut.
#pragma once

#include <vector>

#include "laser/range_line.h"

namespace epcc {

/// (cos, sin) of a beam.
Eigen::Vector2d beamDirection(const LaserScan& scan, int beam);

/// Beams with a return in order. With `circle` they start behind the beam at which the scan is least a line, so that
/// the seam cuts none.
std::vector<LaserSample> readSamples(const LaserScan& scan, const SensorModel& noise, bool circle);

}  // namespace epcc
