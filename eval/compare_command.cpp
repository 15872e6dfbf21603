// SPDX-License-Identifier: BSD-3-Clause
// Runs the comparison or a study, writes its files and prints its table.
#include "eval/compare_command.h"

#include <unistd.h>

#include <memory>
#include <ostream>

#include "datasets/input_error.h"
#include "eval/compare_options.h"
#include "eval/comparison_report.h"
#include "eval/eval_progress.h"
#include "eval/segment_options.h"
#include "eval/study_catalogue.h"
#include "eval/study_report.h"

namespace epcc {
namespace {

/// A progress line that learns the total with the first call.
class LateProgress {
 public:
  explicit LateProgress(std::ostream& err) : err_(err), on_(isatty(STDERR_FILENO) != 0) {}
  void show(std::size_t done, std::size_t total) {
    if (!progress_) progress_ = std::make_unique<EvalProgress>(total, err_, on_);
    progress_->show(done);
  }
  void clear() {
    if (progress_) progress_->clear();
  }

 private:
  std::ostream& err_;
  bool on_;
  std::unique_ptr<EvalProgress> progress_;
};

void compare(const CompareOptions& options, std::ostream& out, LateProgress& progress) {
  const auto show = [&](std::size_t done, std::size_t total) { progress.show(done, total); };
  const Comparison comparison = runComparison(options.comparison, show);
  progress.clear();
  writeComparison(options.out, comparison, options.comparison);
  out << comparisonNote(options.comparison) << "\n\n" << textTable(comparisonTable(comparison));
}

void study(const CompareOptions& options, std::ostream& out, LateProgress& progress) {
  const auto show = [&](std::size_t done, std::size_t total) { progress.show(done, total); };
  const Study study = makeStudy(options.study, options.comparison);
  const StudyResult result = runStudy(study, options.comparison.jobs, show);
  progress.clear();
  writeStudy(options.out, study, result);
  out << studyNote(study) << "\n\n" << textTable(studyTable(study, result));
}

}  // namespace

int compareMain(int argc, const char* const* argv, std::ostream& out, std::ostream& err) {
  CompareOptions options;
  if (const auto done = parseCompareOptions(argc, argv, options, out, err)) return *done;
  LateProgress progress(err);
  const auto complain = [&](const std::string& problem, ExitCode code) {
    progress.clear();
    err << "epcc_compare: " << problem << '\n';
    return static_cast<int>(code);
  };
  try {
    if (options.study.empty())
      compare(options, out, progress);
    else
      study(options, out, progress);
  } catch (const OutputError& error) {
    return complain(error.what(), kExitOutput);
  } catch (const std::exception& error) {
    return complain(printable(error.what(), 1000), kExitInput);
  }
  out.flush();
  return out ? static_cast<int>(kExitDone) : complain("standard output: cannot be written", kExitOutput);
}

}  // namespace epcc
