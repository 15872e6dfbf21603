// SPDX-License-Identifier: BSD-3-Clause
// One pass over the results: sums, errors, and frames.csv as it goes.
#include "eval/run_report.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "datasets/atomic_file.h"
#include "datasets/input_error.h"
#include "eval/evaluation_report.h"
#include "eval/problem_list.h"

namespace epcc {

ExperimentSummary writeRunReport(const std::string& out, const StoredResults& results) {
  const auto path = [&](const char* name) { return (std::filesystem::path(out) / name).string(); };
  ExperimentSummary summary;
  ProblemList problems;
  for (const std::string& problem : results.run().unusable) problems.add(problem);
  writeAtomically(path("frames.csv"), [&](const std::string& temporary) {
    std::ofstream csv(temporary, std::ios::binary);
    csv << csvTable(emptyFramesTable());
    results.forEach([&](const StoredFrame& frame, const std::string&) {
      for (const std::string& problem : frameProblems(frame.records)) problems.add(problem);
      for (const FrameRecord& record : frame.records) {
        summary.add(record);
        csv << frameLine(record);
      }
    });
    csv.close();
    if (!csv) throw OutputError(path("frames.csv"), "file", std::strerror(errno));
  });
  writeTextFile(path("summary.json"), summaryJson(summary.rows()));
  writeTextFile(path("summary.md"), summaryMarkdown(summary, problems.lines()));
  return summary;
}

}  // namespace epcc
