// SPDX-License-Identifier: BSD-3-Clause
// Algorithm 1 on the samples of a laser scan.
#pragma once

#include <vector>

#include "epcc_segmentation/laser_line_extractor.h"
#include "laser/range_line.h"

namespace epcc {

/// A line and the samples it took, in their order.
struct GrownLaserLine {
  RangeLine line;
  std::vector<int> members;
};

/// Whether a line may go on from one of its samples to another, later or earlier one: neighbouring beams always, others
/// across max_gap metres of it.
bool isWithinGap(const RangeLine& line, const LaserSample& from, const LaserSample& to, double max_gap);

/// One pass over the samples. Lines of fewer points than asked for are among the result: what their neighbours took at
/// corners is not yet theirs.
std::vector<GrownLaserLine> growLaserLines(const std::vector<LaserSample>& samples,
                                           const LaserLineParameters& parameters);

}  // namespace epcc
