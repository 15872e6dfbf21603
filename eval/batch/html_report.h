// SPDX-License-Identifier: BSD-3-Clause
// report.html: tables that sort, pictures of frames, errors, doubts, in one file.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "eval/batch/foremost.h"
#include "eval/batch/report_pictures.h"
#include "eval/batch/run_description.h"
#include "eval/experiment/experiment_summary.h"
#include "eval/measures/frame_score.h"
#include "eval/report/table.h"

namespace epcc {

/// Rows of frames and methods for the page: all of them or, of many, the worst.
class WorstRows {
 public:
  void add(const FrameRecord& record);
  /// In the order they came.
  Table table() const;
  /// How many came.
  std::size_t count() const { return count_; }

 private:
  static constexpr std::size_t kMaxRows = 2000;

  Foremost<std::pair<FrameScore, std::size_t>, std::vector<std::string>> rows_{kMaxRows};
  std::size_t count_ = 0;
};

std::string htmlReport(const RunDescription& run, const ExperimentSummary& summary, const WorstRows& rows,
                       const std::vector<PicturedFrame>& pictures, const std::vector<std::string>& problems,
                       const std::vector<std::string>& doubts = {});

}  // namespace epcc
