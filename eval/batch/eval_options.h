// SPDX-License-Identifier: BSD-3-Clause
// The command line of epcc_eval.
#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "datasets/sources/reading_options.h"
#include "eval/batch/shard.h"

namespace epcc {

/// A method whose label images lie in a folder.
struct Predictions {
  std::string name;
  std::string folder;
};

/// What epcc_eval is asked to do.
struct EvalOptions {
  std::vector<std::string> datasets;  ///< folders
  std::vector<std::string> methods;   ///< of segmenterNames(), each once
  std::vector<Predictions> predictions;
  std::string noise;  ///< sensor model as on the command line; empty: the frame's own, else auto
  ReadingOptions reading;
  std::string out;  ///< folder; empty: the tables are printed only
  int jobs = 1;
  Shard shard;                 ///< the part of the frames to be done
  bool resume = false;         ///< go on with the results in `out`
  int seeds = 1;               ///< runs of each method that draws at random
  double frame_timeout = 0.0;  ///< seconds for a frame; 0: no limit
  bool no_times = false;       ///< leave the times out of every result
  bool overlays = false;
  int pictures = 2;  ///< in the report: first, worst and best frames of each data set, so many of each
  bool strict = false;
  std::vector<int> repeatability_lags;  ///< frames; given: sequences with poses are measured instead of frames scored
};

/// Reads the command line. Returns an exit code if the program is done (help, version, or an error that has been
/// reported on `err` in one line), nothing if `options` is to be carried out.
std::optional<int> parseEvalOptions(int argc, const char* const* argv, EvalOptions& options, std::ostream& out,
                                    std::ostream& err);

}  // namespace epcc
