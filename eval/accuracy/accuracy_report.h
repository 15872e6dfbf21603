// SPDX-License-Identifier: BSD-3-Clause
// The tables of docs/research/accuracy.md.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "eval/accuracy/accuracy.h"

namespace epcc {

/// Table and the name of its place in the page.
using NamedTable = std::pair<std::string, Table>;

/// sensors, totals, halves, copies, repeatability, curve, scenes, steps, frames.
std::vector<NamedTable> accuracyTables(const AccuracyResult& result);

/// The page with every table at its place, between the lines "<!-- table NAME -->" and "<!-- end of table -->".
/// Throws InputError naming `file` if a place is missing or has no end.
std::string pageWithTables(const std::string& page, const std::vector<NamedTable>& tables, const std::string& file);

}  // namespace epcc
