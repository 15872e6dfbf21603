// SPDX-License-Identifier: BSD-3-Clause
// Records added up by data set and method.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "eval/experiment/experiment.h"
#include "eval/experiment/time_counts.h"

namespace epcc {

/// Sums over the frames of a data set that a method could be scored on.
struct SummaryRow {
  std::string dataset;
  std::string method;
  long frames = 0;  ///< all frames, those with errors included
  long errors = 0;  ///< frames without a score; they add to no other number
  FrameMeasures measures;
  TimeCounts times;  ///< of the frames that have one

  std::optional<double> medianMs() const { return times.medianMs(); }
  SummaryRow& operator+=(const SummaryRow& other);
};

/// Rows in the order in which data sets and methods are first seen.
class ExperimentSummary {
 public:
  void add(const FrameRecord& record);
  const std::vector<SummaryRow>& rows() const { return rows_; }
  /// Over all data sets, one row a method, the data set called "all".
  std::vector<SummaryRow> totals() const;
  long errors() const;
  /// Frames and methods with a score.
  long scored() const;

 private:
  std::vector<SummaryRow> rows_;
  std::map<std::pair<std::string, std::string>, std::size_t> row_of_;
};

}  // namespace epcc
