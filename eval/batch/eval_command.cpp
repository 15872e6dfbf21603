// SPDX-License-Identifier: BSD-3-Clause
// With --out the results are stored frame by frame and the report is made from them; without, sums are kept in memory.
#include "eval/batch/eval_command.h"

#include <optional>
#include <ostream>
#include <set>

#include "datasets/sources/dataset_registry.h"
#include "datasets/support/input_error.h"
#include "eval/batch/eval_methods.h"
#include "eval/batch/merge_command.h"
#include "eval/batch/repeatability_command.h"
#include "eval/batch/run_folder.h"
#include "eval/batch/run_report.h"
#include "eval/experiment/doubtful_frames.h"
#include "eval/experiment/evaluation_files.h"
#include "eval/experiment/problem_list.h"
#include "eval/program/command_line.h"
#include "eval/program/progress_line.h"
#include "eval/program/reading_arguments.h"
#include "eval/report/evaluation_report.h"

namespace epcc {
namespace {

/// The run as it goes: data sets, problems on `err`, results in --out or, without it, sums.
class EvalRun {
 public:
  EvalRun(const EvalOptions& options, std::ostream& err) : options_(options), err_(err) {}

  /// False if two data sets cannot be told apart.
  bool openDatasets();
  /// False, and said, if an option is of no use to any frame.
  bool readingApplies();
  /// No data set could be opened, as has been said.
  bool nothingToDo() const { return sources_.empty(); }
  const std::vector<std::unique_ptr<FrameSource>>& sources() const { return sources_; }
  /// Data sets that could not be opened.
  std::size_t unusable() const { return unusable_.size(); }
  /// The sums over all results, those found in --out included. A refusal is reported and gives nothing.
  std::optional<ExperimentSummary> run();
  int exitCode(const ExperimentSummary& summary);

 private:
  void say(const std::string& line) { err_ << "epcc_eval: " << printable(line, 2000) << '\n'; }
  void note(const std::string& problem);
  FrameJobs shardJobs() const;
  void score(const FrameJobs& jobs, const FrameDone& done, ExperimentSummary* summary);
  ExperimentSummary runInMemory();
  std::optional<ExperimentSummary> runInFolder();

  const EvalOptions& options_;
  std::ostream& err_;
  std::vector<std::unique_ptr<FrameSource>> sources_;
  std::vector<std::string> unusable_;  ///< data sets that could not be opened: why
};

bool EvalRun::openDatasets() {
  std::set<std::string> names;
  for (const std::string& folder : options_.datasets) {
    if (!names.insert(datasetName(folder)).second) {
      say("DATASET: there are two folders called '" + datasetName(folder) + "'; the results could not be told apart");
      return false;
    }
    try {
      sources_.push_back(openDataset(folder));
    } catch (const InputError& error) {
      note(error.what());
    }
  }
  return true;
}

bool EvalRun::readingApplies() {
  FrameKinds kinds;
  if (options_.reading.areDefault() || !unusable_.empty()) return true;
  for (const auto& source : sources_) kinds.add(*source);
  const std::string problem = uselessOption(options_.reading, kinds);
  if (!problem.empty()) say(problem);
  return problem.empty();
}

void EvalRun::note(const std::string& problem) {
  unusable_.push_back(problem);
  say(problem);
}

FrameJobs EvalRun::shardJobs() const {
  FrameJobs jobs = listJobs(sources_);
  jobs.keepIf([this](const FrameJob& job) { return options_.shard.holds(job.position); });
  return jobs;
}

void EvalRun::score(const FrameJobs& jobs, const FrameDone& done, ExperimentSummary* summary) {
  ProgressLine progress(err_);
  DoubtfulFrames doubtful;
  std::size_t frames = 0;
  const auto in_order = [&](const std::vector<FrameRecord>& records) {
    progress.clear();
    for (const std::string& problem : frameProblems(records)) say(problem);
    doubtful.add(records);
    if (summary != nullptr)
      for (const FrameRecord& record : records) summary->add(record);
    progress.show(++frames, jobs.size());
  };
  progress.show(0, jobs.size());
  runExperiment(jobs, evalMethods(options_), {options_.noise, options_.jobs, options_.reading, options_.frame_timeout},
                done, in_order);
  progress.clear();
  for (const std::string& line : doubtful.lines()) say(line);
}

std::optional<ExperimentSummary> EvalRun::run() {
  if (options_.out.empty()) return runInMemory();
  return runInFolder();
}

ExperimentSummary EvalRun::runInMemory() {
  ExperimentSummary summary;
  score(shardJobs(), {}, &summary);
  return summary;
}

// A frame's record is written last: where there is one, the frame's other files are there too.
std::optional<ExperimentSummary> EvalRun::runInFolder() {
  RunFolder folder(options_.out);
  const RunDescription description = describeRun(options_, sources_, unusable_);
  const std::string refusal = folder.begin(description, options_.resume);
  if (!refusal.empty()) {
    say(refusal);
    return std::nullopt;
  }
  FrameJobs jobs = shardJobs();
  if (options_.resume)
    jobs.keepIf([&](const FrameJob& job) {
      return !loadFrame(options_.out, job.source->dataset(), job.index, description.methods,
                        job.source->name(job.index));
    });
  bool lost = false;
  const auto store = [&](const FrameResult& result) {
    if (result.lost) lost = true;
    writeLabelImages(options_.out, result);
    if (options_.overlays) writeOverlays(options_.out, result);
    storeFrame(options_.out, {result.index, result.file_name, result.records});
  };
  try {
    score(jobs, store, nullptr);
  } catch (...) {
    if (options_.frame_timeout > 0.0) folder.removeLeftovers();  // of processes that were ended at their frames
    throw;
  }
  if (lost) folder.removeLeftovers();
  const auto draw = [this](const PicturedFrame& pictured) {
    for (const auto& source : sources_)
      if (source->dataset() == pictured.frame.records.at(0).dataset) drawPictures(pictured, *source);
  };
  return writeRunReport(options_.out, StoredResults(options_.out, description), draw);
}

int EvalRun::exitCode(const ExperimentSummary& summary) {
  const long errors = summary.errors() + static_cast<long>(unusable_.size());
  const std::string counts = countsOfErrors(errors, summary.scored());
  if (!counts.empty()) say(counts);
  // A shard may hold broken frames only, or none: whether anything was scored is for the merger to say.
  if (options_.shard.count > 1 && !sources_.empty()) return options_.strict && errors > 0 ? kExitInput : kExitDone;
  return exitCodeOf(errors, summary.scored(), options_.strict);
}

}  // namespace

int runEval(const EvalOptions& options, std::ostream& out, std::ostream& err) {
  return runProgram("epcc_eval", out, err, [&]() -> int {
    EvalRun run(options, err);
    if (!run.openDatasets()) return kExitUsage;
    if (run.nothingToDo()) return kExitInput;  // --out is left as it is, for the corrected command
    if (!run.readingApplies()) return kExitUsage;
    if (!options.repeatability_lags.empty()) return runRepeatability(options, run.sources(), run.unusable(), out, err);
    const std::optional<ExperimentSummary> summary = run.run();
    if (!summary) return kExitUsage;
    out << summaryText(*summary);
    return run.exitCode(*summary);
  });
}

int evalMain(int argc, const char* const* argv, std::ostream& out, std::ostream& err) {
  if (argc > 1 && std::string(argv[1]) == "merge") return mergeMain(argc - 1, argv + 1, out, err);
  EvalOptions options;
  const std::optional<int> done = parseEvalOptions(argc, argv, options, out, err);
  return done ? *done : runEval(options, out, err);
}

}  // namespace epcc
