// SPDX-License-Identifier: BSD-3-Clause
// One pass over the sequences; what is left of it is a table.
#include "eval/batch/repeatability_command.h"

#include <algorithm>
#include <filesystem>
#include <ostream>

#include "datasets/support/atomic_file.h"
#include "datasets/support/input_error.h"
#include "datasets/support/output_folder.h"
#include "eval/batch/eval_methods.h"
#include "eval/experiment/problem_list.h"
#include "eval/experiment/sequence_repeatability.h"
#include "eval/program/command_line.h"
#include "eval/program/progress_line.h"
#include "eval/report/repeatability_table.h"

namespace epcc {

namespace {

SequenceResult measure(const EvalOptions& options, const std::vector<std::unique_ptr<FrameSource>>& sources,
                       std::ostream& err) {
  ProgressLine progress(err);
  return measureSequences(listJobs(sources), evalMethods(options),
                          {options.noise, options.repeatability_lags, options.reading},
                          [&](std::size_t done, std::size_t total) { progress.show(done, total); });
}

/// One line a lag that no data set is long enough for.
std::vector<std::string> tooLongLags(const EvalOptions& options,
                                     const std::vector<std::unique_ptr<FrameSource>>& sources) {
  std::size_t frames = 0;
  for (const auto& source : sources) frames = std::max(frames, source->size());
  std::vector<std::string> lines;
  for (const int lag : options.repeatability_lags)
    if (static_cast<std::size_t>(lag) >= frames)
      lines.push_back("--repeatability: " + std::to_string(lag) + " is not below the number of frames, " +
                      std::to_string(frames));
  return lines;
}

}  // namespace

int runRepeatability(const EvalOptions& options, const std::vector<std::unique_ptr<FrameSource>>& sources,
                     std::size_t unusable, std::ostream& out, std::ostream& err) {
  const std::vector<std::string> too_long = tooLongLags(options, sources);
  for (const std::string& line : too_long) err << "epcc_eval: " << line << '\n';
  if (too_long.size() == options.repeatability_lags.size()) return kExitInput;
  if (!options.out.empty()) makeOutputFolder(options.out);
  const SequenceResult result = measure(options, sources, err);
  for (const std::string& problem : result.problems) err << "epcc_eval: " << printable(problem, 2000) << '\n';
  long pairs = 0;
  for (const RepeatabilityRow& row : result.rows) pairs += row.sums.pairs;
  if (!options.out.empty())
    writeTextFile((std::filesystem::path(options.out) / "repeatability.csv").string(),
                  csvTable(repeatabilityCounts(result.rows)));
  out << textTable(repeatabilityTable(result.rows));
  return exitCodeOf(static_cast<long>(result.problems.size() + too_long.size() + unusable), pairs, options.strict);
}

}  // namespace epcc
