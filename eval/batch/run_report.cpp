// SPDX-License-Identifier: BSD-3-Clause
// The stored results are read once: memory does not grow with the number of frames.
#include "eval/batch/run_report.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "datasets/support/atomic_file.h"
#include "datasets/support/input_error.h"
#include "eval/batch/html_report.h"
#include "eval/experiment/doubtful_frames.h"
#include "eval/experiment/problem_list.h"
#include "eval/report/evaluation_report.h"

namespace epcc {

ExperimentSummary writeRunReport(const std::string& out, const StoredResults& results, const Draw& draw) {
  const auto path = [&](const char* name) { return (std::filesystem::path(out) / name).string(); };
  ExperimentSummary summary;
  ProblemList problems;
  DoubtfulFrames doubtful;
  PictureChoice choice(results.run().pictures);
  WorstRows rows;
  for (const std::string& problem : results.run().unusable) problems.add(problem);
  writeAtomically(path("frames.csv"), [&](const std::string& temporary) {
    std::ofstream csv(temporary, std::ios::binary);
    csv << csvTable(emptyFramesTable());
    results.forEach([&](const StoredFrame& frame, const std::string& folder) {
      choice.add(frame, folder);
      doubtful.add(frame.records);
      for (const std::string& problem : frameProblems(frame.records)) problems.add(problem);
      for (const FrameRecord& record : frame.records) {
        summary.add(record);
        rows.add(record);
        csv << frameLine(record);
      }
    });
    csv.close();
    if (!csv) throw OutputError(path("frames.csv"), "file", std::strerror(errno));
  });
  const std::vector<PicturedFrame> pictures = choice.chosen();
  if (draw)
    for (const PicturedFrame& pictured : pictures) draw(pictured);
  const bool several = results.run().datasets.size() > 1;
  writeTextFile(path("summary.json"),
                summaryJson(summary.rows(), several ? summary.totals() : std::vector<SummaryRow>(), doubtful));
  writeTextFile(path("summary.md"), summaryMarkdown(summary, problems.lines(), doubtful.lines()));
  writeTextFile(path("summary.tex"), summaryLatex(summary));
  writeTextFile(path("report.html"),
                htmlReport(results.run(), summary, rows, pictures, problems.lines(), doubtful.lines()));
  return summary;
}

}  // namespace epcc
