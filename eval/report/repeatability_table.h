// SPDX-License-Identifier: BSD-3-Clause
// Repeatability as tables.
#pragma once

#include <vector>

#include "eval/experiment/sequence_repeatability.h"
#include "eval/report/table.h"

namespace epcc {

/// dataset, method, lag, pairs, and what was found: shares of the shared pixels, regions, median angle and offset.
Table repeatabilityTable(const std::vector<RepeatabilityRow>& rows);
/// The counts behind it, for repeatability.csv.
Table repeatabilityCounts(const std::vector<RepeatabilityRow>& rows);

/// The cells of one row behind its names and lag: "pixels", "labelled", "regions repeated", "angle deg", "offset mm".
std::vector<std::string> repeatabilityCells(const Repeatability& sums);

}  // namespace epcc
