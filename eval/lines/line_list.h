// SPDX-License-Identifier: BSD-3-Clause
// The lines of a log as CSV.
#pragma once

#include <string>

#include "eval/lines/log_lines.h"

namespace epcc {

/// A heading with units, then one line of text for each segment; numbers with as many digits as it takes to read them
/// back exactly; what a log does not have is empty. The columns are explained in docs/reference/epcc_lines.md.
std::string lineListCsv(const LaserLog& log, const LogLines& lines);

}  // namespace epcc
