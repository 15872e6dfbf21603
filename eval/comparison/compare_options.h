// SPDX-License-Identifier: BSD-3-Clause
// The command line of epcc_compare.
#pragma once

#include <iosfwd>
#include <optional>
#include <string>

#include "eval/comparison/comparison.h"

namespace epcc {

/// What epcc_compare is asked to do.
struct CompareOptions {
  ComparisonOptions comparison;  ///< noise, seeds and jobs serve the studies too
  std::string study;             ///< name of a study; empty: the comparison
  std::string out = "results";   ///< folder
};

/// Reads the command line. Returns an exit code if the program is done (help, version, or an error that has been
/// reported on `err` in one line), nothing if `options` is to be carried out.
std::optional<int> parseCompareOptions(int argc, const char* const* argv, CompareOptions& options, std::ostream& out,
                                       std::ostream& err);

}  // namespace epcc
