// SPDX-License-Identifier: BSD-3-Clause
// epcc_scene without its main: renders frames, or measures the noise of real ones.
#pragma once

#include <iosfwd>

namespace epcc {

/// Runs the program; returns its exit code.
int sceneMain(int argc, const char* const* argv, std::ostream& out, std::ostream& err);

}  // namespace epcc
