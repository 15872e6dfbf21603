// SPDX-License-Identifier: BSD-3-Clause
// The tables and files that epcc_eval leaves.
#pragma once

#include <string>
#include <vector>

#include "eval/experiment/doubtful_frames.h"
#include "eval/experiment/experiment_summary.h"
#include "eval/report/table.h"

namespace epcc {

/// The rows and, for several data sets, the totals below them.
std::vector<SummaryRow> withTotals(const ExperimentSummary& summary);

/// summary.json, version 1: see docs/reference/evaluation.md. median_ms is null where no time is known. "totals" and
/// "doubtful" only if there are any.
std::string summaryJson(const std::vector<SummaryRow>& rows, const std::vector<SummaryRow>& totals = {},
                        const DoubtfulFrames& doubtful = {});

/// Sums by data set and method, the columns of summary.json.
Table countsTable(const std::vector<SummaryRow>& rows);
/// Shares and means by data set and method.
Table ratesTable(const std::vector<SummaryRow>& rows);

/// One row a frame and method, to be filled row by row.
Table emptyFramesTable();
void addFrameRow(const FrameRecord& record, Table& table);
/// The same row alone, as a line of frames.csv.
std::string frameLine(const FrameRecord& record);

/// The columns of report.html's rows, and one row: the counts of a frame and method, its time and its error.
std::vector<TableColumn> pageColumns();
std::vector<std::string> pageCells(const FrameRecord& record);

/// Both tables as LaTeX, totals included if there are several data sets.
std::string summaryLatex(const ExperimentSummary& summary);
/// Both tables, totals if there are several data sets, the errors by name, and what is doubtful.
std::string summaryMarkdown(const ExperimentSummary& summary, const std::vector<std::string>& problems,
                            const std::vector<std::string>& doubts = {});
/// Both tables for the terminal, with totals if there are several data sets.
std::string summaryText(const ExperimentSummary& summary);

}  // namespace epcc
