// SPDX-License-Identifier: BSD-3-Clause
// The command line of epcc_lines.
#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "epcc_segmentation/laser_line_extractor.h"

namespace epcc {

/// What epcc_lines is asked to do.
struct LinesOptions {
  std::vector<std::string> logs;
  std::string out;
  std::optional<SensorModel> noise;  ///< none: measured on each log
  LaserLineParameters parameters;
  std::optional<double> max_range;  ///< metres, in place of what a log says
  std::optional<int> scan;          ///< the one that is drawn
  int jobs = 1;                     ///< 0: one a core
  bool timing = false;
};

/// Reads the command line. Returns an exit code if the program is done (help, version, or an error that has been
/// reported on `err` in one line), nothing if `options` is to be carried out.
std::optional<int> parseLinesOptions(int argc, const char* const* argv, LinesOptions& options, std::ostream& out,
                                     std::ostream& err);

}  // namespace epcc
