// SPDX-License-Identifier: BSD-3-Clause
// Coverage of each surface by the clusters it dominates.
#include "eval/measures/paper_measures.h"

namespace epcc {

PaperMeasures& PaperMeasures::operator+=(const PaperMeasures& other) {
  surfaces += other.surfaces;
  clusters += other.clusters;
  detected += other.detected;
  over_segmented += other.over_segmented;
  under_segmented += other.under_segmented;
  return *this;
}

PaperMeasures paperMeasures(const OverlapTable& table) {
  PaperMeasures measures;
  measures.surfaces = static_cast<long>(table.surfaceCount());
  measures.clusters = static_cast<long>(table.clusterCount());
  std::vector<long> covered(table.surfaceCount() + 1, 0);
  std::vector<int> large_parts(table.surfaceCount() + 1, 0);
  for (std::size_t c = 1; c <= table.clusterCount(); ++c) {
    const std::size_t g = table.dominant(c);
    covered[g] += table.overlap(c, g);
    if (20 * table.overlap(c, g) >= table.surfaceSize(g)) ++large_parts[g];
  }
  for (std::size_t g = 1; g <= table.surfaceCount(); ++g) {
    if (2 * covered[g] < table.surfaceSize(g)) continue;
    ++measures.detected;
    if (large_parts[g] >= 2) ++measures.over_segmented;
    if (5 * covered[g] < 4 * table.surfaceSize(g)) ++measures.under_segmented;
  }
  return measures;
}

}  // namespace epcc
