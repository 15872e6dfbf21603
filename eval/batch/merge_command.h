// SPDX-License-Identifier: BSD-3-Clause
// epcc_eval merge: one report of the shards of a run.
#pragma once

#include <iosfwd>

namespace epcc {

/// `argv` begins at the word "merge". Prints the tables on `out`, writes the report to --out; problems go to `err`,
/// one line each. Returns the exit code.
int mergeMain(int argc, const char* const* argv, std::ostream& out, std::ostream& err);

}  // namespace epcc
