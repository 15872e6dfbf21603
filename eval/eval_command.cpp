// SPDX-License-Identifier: BSD-3-Clause
// Opens the data sets, runs the experiment, writes the report.
#include "eval/eval_command.h"

#include <unistd.h>

#include <filesystem>
#include <ostream>
#include <set>

#include "datasets/atomic_file.h"
#include "datasets/input_error.h"
#include "eval/eval_progress.h"
#include "eval/evaluation_files.h"
#include "eval/evaluation_report.h"
#include "eval/segment_options.h"

namespace epcc {
namespace {

namespace fs = std::filesystem;

/// The run as it goes: sums, rows of frames.csv, problems on `err` and for the report.
class EvalRun {
 public:
  EvalRun(const EvalOptions& options, std::ostream& err) : options_(options), err_(err), frames_(emptyFramesTable()) {}

  /// False if two data sets cannot be told apart.
  bool openDatasets();
  void score();
  void writeReport() const;
  int exitCode();

  const ExperimentSummary& summary() const { return summary_; }

 private:
  void say(const std::string& line) { err_ << "epcc_eval: " << printable(line, 2000) << '\n'; }
  void note(const std::string& problem);
  void take(const std::vector<FrameRecord>& records);
  std::vector<Method> methods() const;

  const EvalOptions& options_;
  std::ostream& err_;
  std::vector<std::unique_ptr<FrameSource>> sources_;
  ExperimentSummary summary_;
  Table frames_;
  std::vector<std::string> problems_;
  std::size_t unusable_datasets_ = 0;
};

bool EvalRun::openDatasets() {
  std::set<std::string> names;
  for (const std::string& folder : options_.datasets) {
    if (!names.insert(folderName(folder)).second) {
      say("DATASET: there are two folders called '" + folderName(folder) + "'; the results could not be told apart");
      return false;
    }
    try {
      sources_.push_back(openDataset(folder));
    } catch (const InputError& error) {
      ++unusable_datasets_;
      note(error.what());
    }
  }
  return true;
}

void EvalRun::note(const std::string& problem) {
  problems_.push_back(problem);
  say(problem);
}

// A frame that cannot be read is one problem, not one for each method.
void EvalRun::take(const std::vector<FrameRecord>& records) {
  std::string last;
  for (const FrameRecord& record : records) {
    summary_.add(record);
    addFrameRow(record, frames_);
    if (!record.error.empty() && record.error != last)
      note(record.dataset + "/" + record.frame + ": " + record.method + ": " + record.error);
    last = record.error;
  }
}

std::vector<Method> EvalRun::methods() const {
  std::vector<Method> methods;
  for (const std::string& name : options_.methods) methods.push_back(registeredMethod(name));
  for (const Predictions& p : options_.predictions) methods.push_back(importedMethod(p.name, p.folder));
  return methods;
}

void EvalRun::score() {
  const std::vector<FrameJob> jobs = listJobs(sources_);
  EvalProgress progress(jobs.size(), err_, isatty(STDERR_FILENO) != 0);
  std::size_t done = 0;
  const auto write = [&](const FrameResult& result) {
    if (options_.out.empty()) return;
    writeLabelImages(options_.out, result);
    if (options_.overlays) writeOverlays(options_.out, result);
  };
  const auto in_order = [&](const std::vector<FrameRecord>& records) {
    progress.clear();
    take(records);
    progress.show(++done);
  };
  progress.show(0);
  runExperiment(jobs, methods(), {options_.noise, options_.jobs}, write, in_order);
  progress.clear();
}

void EvalRun::writeReport() const {
  const auto path = [this](const char* name) { return (fs::path(options_.out) / name).string(); };
  writeTextFile(path("summary.json"), summaryJson(summary_.rows()));
  writeTextFile(path("frames.csv"), csvTable(frames_));
  writeTextFile(path("summary.md"), summaryMarkdown(summary_, problems_));
}

int EvalRun::exitCode() {
  const long scored = summary_.scored();
  const long errors = summary_.errors() + static_cast<long>(unusable_datasets_);
  if (errors > 0)
    say(std::to_string(errors) + (errors == 1 ? " error, " : " errors, ") + std::to_string(scored) +
        (scored == 1 ? " result scored" : " results scored"));
  if (scored == 0) return kExitInput;
  return options_.strict && errors > 0 ? kExitInput : kExitDone;
}

void makeFolder(const std::string& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (!fs::is_directory(folder))
    throw OutputError(folder, "folder", "cannot be made" + (error ? ", " + error.message() : std::string()));
}

}  // namespace

int runEval(const EvalOptions& options, std::ostream& out, std::ostream& err) {
  try {
    EvalRun run(options, err);
    if (!run.openDatasets()) return kExitUsage;
    if (!options.out.empty()) makeFolder(options.out);
    run.score();
    if (!options.out.empty()) run.writeReport();
    out << summaryText(run.summary()) << std::flush;
    if (!out) throw OutputError("standard output", "tables", "cannot be written");
    return run.exitCode();
  } catch (const OutputError& error) {
    err << "epcc_eval: " << error.what() << '\n';
    return kExitOutput;
  }
}

int evalMain(int argc, const char* const* argv, std::ostream& out, std::ostream& err) {
  EvalOptions options;
  const std::optional<int> done = parseEvalOptions(argc, argv, options, out, err);
  return done ? *done : runEval(options, out, err);
}

}  // namespace epcc
