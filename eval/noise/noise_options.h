// SPDX-License-Identifier: BSD-3-Clause
// The command line of epcc_noise.
#pragma once

#include <iosfwd>
#include <optional>
#include <string>

#include "eval/segment/segment_options.h"

namespace epcc {

/// What epcc_noise is asked to do.
struct NoiseCommandOptions {
  SegmentOptions input;  ///< its inputs and camera alone
  std::string out;       ///< path and name of the outputs, without .json and .png
};

/// Reads the command line. Returns an exit code if the program is done (help, version, or an error that has been
/// reported on `err` in one line), nothing if `options` is to be carried out.
std::optional<int> parseNoiseOptions(int argc, const char* const* argv, NoiseCommandOptions& options, std::ostream& out,
                                     std::ostream& err);

}  // namespace epcc
