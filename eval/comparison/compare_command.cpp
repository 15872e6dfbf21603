// SPDX-License-Identifier: BSD-3-Clause
// Runs the comparison or a study, writes its files and prints its table.
#include "eval/comparison/compare_command.h"

#include <ostream>

#include "datasets/support/input_error.h"
#include "datasets/support/output_folder.h"
#include "eval/comparison/compare_options.h"
#include "eval/comparison/comparison_report.h"
#include "eval/comparison/study_catalogue.h"
#include "eval/comparison/study_report.h"
#include "eval/program/command_line.h"
#include "eval/program/progress_line.h"

namespace epcc {
namespace {

void compare(const CompareOptions& options, std::ostream& out, ProgressLine& progress) {
  const auto show = [&](std::size_t done, std::size_t total) { progress.show(done, total); };
  const Comparison comparison = runComparison(options.comparison, show);
  progress.clear();
  writeComparison(options.out, comparison, options.comparison);
  out << comparisonNote(options.comparison) << "\n\n" << textTable(comparisonTable(comparison));
}

void study(const CompareOptions& options, std::ostream& out, ProgressLine& progress) {
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
  return runProgram("epcc_compare", out, err, [&] {
    // What cannot be written is told before the work.
    makeOutputFolder(options.out, options.study.empty() ? comparisonFiles() : studyFiles(options.study));
    ProgressLine progress(err);
    if (options.study.empty())
      compare(options, out, progress);
    else
      study(options, out, progress);
    return kExitDone;
  });
}

}  // namespace epcc
