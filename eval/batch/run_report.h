// SPDX-License-Identifier: BSD-3-Clause
// The report of a run, made from its stored results.
#pragma once

#include <functional>
#include <string>

#include "eval/batch/report_pictures.h"
#include "eval/batch/stored_results.h"
#include "eval/experiment/experiment_summary.h"

namespace epcc {

/// Draws the pictures of the frames chosen. Empty where no data set is at hand: those drawn before are taken.
using Draw = std::function<void(const PicturedFrame&)>;

/// Writes summary.json, .md and .tex, frames.csv and report.html to `out` and returns the sums. Throws OutputError, and
/// InputError if results are missing; then no file has changed.
ExperimentSummary writeRunReport(const std::string& out, const StoredResults& results, const Draw& draw);

}  // namespace epcc
