// SPDX-License-Identifier: BSD-3-Clause
// What a run of epcc_eval is: everything its results depend on, kept beside them as run.json.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "datasets/sources/frame_source.h"
#include "eval/batch/eval_options.h"

namespace epcc {

/// A data set as the run found it; the hash is over the names of its frames.
struct RunDataset {
  std::string name;
  std::size_t frames = 0;
  std::string names_hash;
};

struct RunDescription {
  std::string program;                   ///< version of epcc_eval
  std::vector<std::string> methods;      ///< in the order of the records
  std::vector<std::string> predictions;  ///< NAME=DIR, part of the methods too
  std::string noise;                     ///< as on the command line, and what its file says
  std::string reading;                   ///< options of the input as on the command line
  bool overlays = false;
  bool times = true;           ///< results have them
  double frame_timeout = 0.0;  ///< seconds; 0: no limit
  std::size_t pictures = 0;    ///< of each kind and data set in the report; no result depends on it
  Shard shard;
  std::vector<RunDataset> datasets;
  std::vector<std::string> unusable;  ///< data sets that could not be opened: why
};

RunDescription describeRun(const EvalOptions& options, const std::vector<std::unique_ptr<FrameSource>>& sources,
                           const std::vector<std::string>& unusable);

/// OUT/run.json. Writing throws OutputError, reading InputError.
std::string runDescriptionPath(const std::string& out);
void writeRunDescription(const std::string& out, const RunDescription& run);
RunDescription readRunDescription(const std::string& out);

/// What the results of two runs would differ by, in words; empty if they can be parts of one. Shards and data sets are
/// left out: see the next two.
std::string optionDifference(const RunDescription& there, const RunDescription& here);
/// Whether both have the same frames in the same order.
std::string datasetDifference(const RunDescription& there, const RunDescription& here);
std::string datasetDifference(const RunDataset& there, const RunDataset& here);

}  // namespace epcc
