// SPDX-License-Identifier: BSD-3-Clause
// Pieces of one wall that something in front of it cuts.
#pragma once

#include <vector>

#include "laser/laser_line_growing.h"

namespace epcc {

/// Joins lines that are one by all evidence:
/// - one line fits both as well as two do, by the errors of the noise model;
/// - each predicts where the other is to a few sigma: short pieces far apart prove nothing;
/// - the stretch between them is at most max_hidden, and beams that see it are stopped before it. Beams that pass
///   through, or do not return, are an opening: no more than max_gap of them in a row.
/// `circle` says that the first and the last sample are neighbours. Members of a joined line stay in the order of the
/// beams, from its first on; with `circle` they may pass the seam.
void joinHiddenLines(const std::vector<LaserSample>& samples, const LaserScan& scan, const SensorModel& noise,
                     const LaserLineParameters& parameters, bool circle, std::vector<GrownLaserLine>& lines);

/// Gives lines the pieces of their wall that are too short to be lines: four beams in a row or more that no line has,
/// all on the line, behind something that is in front of it, under the conditions of joinHiddenLines
/// and no farther on than what is known of the line is long.
void adoptHiddenPieces(const std::vector<LaserSample>& samples, const LaserScan& scan, const SensorModel& noise,
                       const LaserLineParameters& parameters, bool circle, std::vector<GrownLaserLine>& lines);

}  // namespace epcc
