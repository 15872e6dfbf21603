// SPDX-License-Identifier: BSD-3-Clause
// The SegComp measures of Hoover et al., PAMI 1996.
#pragma once

#include "eval/measures/overlap_table.h"

namespace epcc {

/// Counts of one frame or, added up, of many.
struct SegcompMeasures {
  long correct = 0;
  long over = 0;    ///< surfaces that two or more clusters share
  long under = 0;   ///< clusters that two or more surfaces share
  long missed = 0;  ///< surfaces in no class
  long noise = 0;   ///< clusters in no class

  SegcompMeasures& operator+=(const SegcompMeasures& other);
};

/// Classes at the tolerance T in (0.5, 1]. A region that qualifies for several classes stays in the instance
/// with the greater mean overlap.
SegcompMeasures segcompMeasures(const OverlapTable& table, double tolerance = 0.8);

}  // namespace epcc
