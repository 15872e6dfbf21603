// SPDX-License-Identifier: BSD-3-Clause
// Where the lines of a scan end.
#pragma once

#include <vector>

#include "laser/laser_line_growing.h"

namespace epcc {

/// Fits every line anew and gives it the samples that are its own: corners of neighbours lie where both fit best, and
/// from its middle a line takes what it accepts up to there, or up to a gap. `lines` are in the order of their samples;
/// those that are left with too few points are dropped.
void settleBorders(const std::vector<LaserSample>& samples, const SensorModel& noise,
                   const LaserLineParameters& parameters, std::vector<GrownLaserLine>& lines);

}  // namespace epcc
