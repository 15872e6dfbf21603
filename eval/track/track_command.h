// SPDX-License-Identifier: BSD-3-Clause
// epcc_track without its main: planes over time.
#pragma once

#include <iosfwd>

namespace epcc {

/// Runs the program; returns its exit code.
int trackMain(int argc, const char* const* argv, std::ostream& out, std::ostream& err);

}  // namespace epcc
