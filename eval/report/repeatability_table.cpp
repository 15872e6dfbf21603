// SPDX-License-Identifier: BSD-3-Clause
// Shares with two decimals, medians in degrees and millimetres; "-" where there is nothing to divide by.
#include "eval/report/repeatability_table.h"

namespace epcc {

namespace {

std::string share(long part, long whole) {
  return whole > 0 ? numberCell(static_cast<double>(part) / static_cast<double>(whole), 2) : "-";
}

std::string medianThousandths(const ValueCounts& values, int decimals) {
  const auto median = values.median();
  return median ? numberCell(1e-3 * *median, decimals) : "-";
}

}  // namespace

std::vector<std::string> repeatabilityCells(const Repeatability& sums) {
  return {share(sums.repeated_pixels, sums.shared), share(sums.labelled, sums.shared),
          std::to_string(sums.repeated) + " of " + std::to_string(sums.regions),
          medianThousandths(sums.millidegrees, 2), medianThousandths(sums.micrometres, 1)};
}

Table repeatabilityTable(const std::vector<RepeatabilityRow>& rows) {
  Table table;
  for (const char* title : {"dataset", "method"}) table.columns.push_back({title, false});
  for (const char* title : {"lag", "pairs", "pixels", "labelled", "regions repeated", "angle deg", "offset mm"})
    table.columns.push_back({title, true});
  for (const RepeatabilityRow& row : rows) {
    std::vector<std::string> cells = {row.dataset, row.method, std::to_string(row.lag), std::to_string(row.sums.pairs)};
    const std::vector<std::string> found = repeatabilityCells(row.sums);
    cells.insert(cells.end(), found.begin(), found.end());
    table.rows.push_back(cells);
  }
  return table;
}

Table repeatabilityCounts(const std::vector<RepeatabilityRow>& rows) {
  Table table;
  for (const char* title : {"dataset", "method", "lag", "pairs", "shared", "labelled", "repeated_pixels", "regions",
                            "repeated", "median_angle_deg", "median_offset_mm"})
    table.columns.push_back({title, true});
  for (const RepeatabilityRow& row : rows) {
    const Repeatability& sums = row.sums;
    std::vector<std::string> cells = {row.dataset, row.method};
    for (const long value : {static_cast<long>(row.lag), sums.pairs, sums.shared, sums.labelled, sums.repeated_pixels,
                             sums.regions, sums.repeated})
      cells.push_back(std::to_string(value));
    cells.push_back(medianThousandths(sums.millidegrees, 3));
    cells.push_back(medianThousandths(sums.micrometres, 3));
    table.rows.push_back(cells);
  }
  return table;
}

}  // namespace epcc
