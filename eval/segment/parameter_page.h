// SPDX-License-Identifier: BSD-3-Clause
// The page of all parameters: what --list-parameters prints and docs/reference/parameters.md holds.
#pragma once

#include <string>

namespace epcc {

/// Markdown, a table for each group of parameters, from the core's parameter table.
std::string parameterPage();

}  // namespace epcc
