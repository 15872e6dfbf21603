// SPDX-License-Identifier: BSD-3-Clause
// The paper's measures (Sec. 7.1, Table 4) as docs/reference/evaluation.md defines them.
#pragma once

#include "eval/measures/overlap_table.h"

namespace epcc {

/// Counts of one frame or, added up, of many.
struct PaperMeasures {
  long surfaces = 0;         ///< N
  long clusters = 0;         ///< IC
  long detected = 0;         ///< D: coverage at least 50 %
  long over_segmented = 0;   ///< N_o: detected, two or more clusters of at least 5 % each
  long under_segmented = 0;  ///< N_u: detected, coverage below 80 %

  PaperMeasures& operator+=(const PaperMeasures& other);
};

PaperMeasures paperMeasures(const OverlapTable& table);

}  // namespace epcc
