// SPDX-License-Identifier: BSD-3-Clause
// epcc_eval --repeatability: sequences with poses instead of labelled frames.
#pragma once

#include <iosfwd>
#include <memory>
#include <vector>

#include "datasets/sources/frame_source.h"
#include "eval/batch/eval_options.h"

namespace epcc {

/// Measures every method on every sequence, prints the table on `out`, and writes repeatability.csv into --out.
/// Problems go to `err`, one line each. Returns the exit code; `unusable` data sets, reported already, count as errors.
int runRepeatability(const EvalOptions& options, const std::vector<std::unique_ptr<FrameSource>>& sources,
                     std::size_t unusable, std::ostream& out, std::ostream& err);

}  // namespace epcc
