// SPDX-License-Identifier: BSD-3-Clause
// The comparison as tables, JSON and the picture of Fig. 21.
#pragma once

#include <string>

#include "eval/comparison/comparison.h"
#include "eval/report/table.h"

namespace epcc {

/// Mean ± standard deviation with the published value beside it.
Table comparisonTable(const Comparison& comparison);
/// One number a cell, the columns named as the keys of comparisonJson().
Table comparisonNumbers(const Comparison& comparison);
/// What was run, in words: surrogates, noise, parameters, seeds.
std::string comparisonNote(const ComparisonOptions& options);
/// results/table4.json, version 1: see docs/research/comparison.md. Numbers the paper does not have are null.
std::string comparisonJson(const Comparison& comparison, const ComparisonOptions& options);

/// Names of the files that writeComparison() leaves.
std::vector<std::string> comparisonFiles();

/// Writes OUT/table4.md, .csv, .json, .tex and OUT/figure21.png; makes the folder. Throws OutputError.
void writeComparison(const std::string& out, const Comparison& comparison, const ComparisonOptions& options);

}  // namespace epcc
