// SPDX-License-Identifier: BSD-3-Clause
// From the samples of a line to what is told of it.
#pragma once

#include <optional>
#include <vector>

#include "laser/laser_line_growing.h"

namespace epcc {

/// Fits the line once more and describes it. The covariance is that of the noise model, or of the errors themselves
/// where they are larger by more than chance; grown.line is left with it. Nothing if no line fits the samples, as with
/// ranges of many orders of magnitude.
std::optional<LaserLine> describeLine(const LaserScan& scan, const std::vector<LaserSample>& samples,
                                      const SensorModel& noise, GrownLaserLine& grown);

/// Lines of which one begins where the other ends, beside each other in the scan, end where they cross, if that is
/// where their beams end and is better known so. grown[k] is what lines[k] describes.
void placeCorners(const LaserScan& scan, const std::vector<GrownLaserLine>& grown, LaserLines& result);

}  // namespace epcc
