// SPDX-License-Identifier: BSD-3-Clause
// Consistency as a table, JSON and a picture.
#pragma once

#include <string>
#include <vector>

#include "eval/consistency/consistency.h"
#include "eval/pictures/plot.h"
#include "eval/report/table.h"

namespace epcc {

/// Share of a chi-square distribution with 2 or 3 degrees of freedom that lies below a value.
double chiSquareBelow(double value, int degrees);

/// A row for each error and way: how many, mean, median, and how many lie below the 95 % of a chi-square distribution.
Table consistencyTable(const std::vector<ConsistencyRow>& rows);
/// A row for each error, way and surface: where the means come from.
Table surfacesTable(const std::vector<ConsistencyRow>& rows);
/// {"version": 1, "rows": [{"error", "labels", "parameters", "count", "mean", "quantiles": {"0.05": ...}}]}.
std::string consistencyJson(const std::vector<ConsistencyRow>& rows);
/// Shares below each value for planes (3) or lines (2), beside those of the chi-square distribution: of white and
/// stereo-like error for planes, of every error for lines.
Plot consistencyChart(const std::vector<ConsistencyRow>& rows, int parameters);

}  // namespace epcc
