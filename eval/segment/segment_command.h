// SPDX-License-Identifier: BSD-3-Clause
// What epcc_segment does once its command line is understood.
#pragma once

#include <iosfwd>

#include "eval/segment/segment_options.h"

namespace epcc {

/// Segments every input, writes what was asked for and prints the table of planes on `out`. Problems go to `err`,
/// one line each. Returns the exit code: kExitOutput before kExitInput if both occur.
int runSegment(const SegmentOptions& options, std::ostream& out, std::ostream& err);

/// The whole program: command line in, exit code out.
int segmentMain(int argc, const char* const* argv, std::ostream& out, std::ostream& err);

}  // namespace epcc
