// SPDX-License-Identifier: BSD-3-Clause
// The report of a run, made from its stored results.
#pragma once

#include <string>

#include "eval/experiment_summary.h"
#include "eval/stored_results.h"

namespace epcc {

/// Writes summary.json, summary.md and frames.csv to `out` and returns the sums. Throws OutputError, and InputError if
/// results are missing; then no file has changed.
ExperimentSummary writeRunReport(const std::string& out, const StoredResults& results);

}  // namespace epcc
