// SPDX-License-Identifier: BSD-3-Clause
// What epcc_eval does once its command line is understood.
#pragma once

#include <iosfwd>

#include "eval/batch/eval_options.h"

namespace epcc {

/// Scores every method on every frame, prints the tables on `out` and writes the files of --out. Problems go to
/// `err`, one line each. Returns the exit code.
int runEval(const EvalOptions& options, std::ostream& out, std::ostream& err);

/// The whole program: command line in, exit code out.
int evalMain(int argc, const char* const* argv, std::ostream& out, std::ostream& err);

}  // namespace epcc
