// SPDX-License-Identifier: BSD-3-Clause
// The folders must hold one run without gaps, or runs over different data sets, before their results are joined.
#include "eval/batch/merge_command.h"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>
#include <ostream>

#include "datasets/support/input_error.h"
#include "eval/batch/run_folder.h"
#include "eval/batch/run_report.h"
#include "eval/experiment/problem_list.h"
#include "eval/program/command_line.h"
#include "eval/report/evaluation_report.h"

namespace epcc {

namespace {

struct MergeOptions {
  std::vector<std::string> folders;
  std::string out;
  bool strict = false;
};

constexpr const char* kMergeDescription =
    "Makes one report of the shards of a run (epcc_eval ... --shard I/N --out DIR), or of runs over different data\n"
    "sets. Any sharding gives the same report, up to times.";

constexpr const char* kMergeFooter =
    "Exit codes: 0 done, 2 wrong usage, 3 a shard or a result is missing or given twice, or the shards are of "
    "different\n"
    "runs, or nothing was scored, or, with --strict, a frame could not be scored, 4 an output could not be written.";

std::optional<int> parseMergeOptions(int argc, const char* const* argv, MergeOptions& options, std::ostream& out,
                                     std::ostream& err) {
  CLI::App app(kMergeDescription, "epcc_eval merge");
  app.footer(kMergeFooter);
  app.add_option("DIR", options.folders, "Folders that epcc_eval --out has left")->type_name("");
  app.add_option("--out", options.out, "Folder for the report")->type_name("DIR");
  app.add_flag("--strict", options.strict, "Exit code 3 if any frame could not be scored");
  return parseCommandLine(app, argc, argv, out, err, [&] {
    require(!options.folders.empty(), "name at least one DIR");
    require(!options.out.empty(), "name the folder of the report, --out DIR");
    for (const std::string& folder : options.folders) {
      std::error_code error;
      require(!std::filesystem::equivalent(folder, options.out, error),
              "--out: " + options.out + " is one of the folders to be merged");
    }
  });
}

int merge(const MergeOptions& options, std::ostream& out, std::ostream& err) {
  const StoredResults results = StoredResults::merged(options.folders);
  const RunFolder folder(options.out);
  const std::string refusal = folder.refuseRun();
  if (!refusal.empty()) return reportProblem("epcc_eval merge", err, refusal, kExitUsage);
  const ExperimentSummary summary = writeRunReport(options.out, results, {});
  out << summaryText(summary);
  const long errors = summary.errors() + static_cast<long>(results.run().unusable.size());
  const std::string counts = countsOfErrors(errors, summary.scored());
  if (!counts.empty()) err << "epcc_eval: " << counts << '\n';
  return exitCodeOf(errors, summary.scored(), options.strict);
}

}  // namespace

int mergeMain(int argc, const char* const* argv, std::ostream& out, std::ostream& err) {
  MergeOptions options;
  if (const auto done = parseMergeOptions(argc, argv, options, out, err)) return *done;
  return runProgram("epcc_eval merge", out, err, [&] { return merge(options, out, err); });
}

}  // namespace epcc
