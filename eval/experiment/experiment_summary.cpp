// SPDX-License-Identifier: BSD-3-Clause
// Records are added up by data set and method; times are counted, for their median.
#include "eval/experiment/experiment_summary.h"

#include <algorithm>

namespace epcc {

SummaryRow& SummaryRow::operator+=(const SummaryRow& other) {
  frames += other.frames;
  errors += other.errors;
  measures += other.measures;
  times += other.times;
  return *this;
}

void ExperimentSummary::add(const FrameRecord& record) {
  const auto [found, is_new] = row_of_.try_emplace({record.dataset, record.method}, rows_.size());
  if (is_new) rows_.push_back({record.dataset, record.method, 0, 0, {}, {}});
  SummaryRow& row = rows_[found->second];
  ++row.frames;
  if (!record.error.empty()) {
    ++row.errors;
    return;
  }
  row.measures += record.measures;
  if (record.ms) row.times.add(*record.ms);
}

std::vector<SummaryRow> ExperimentSummary::totals() const {
  std::vector<SummaryRow> totals;
  for (const SummaryRow& row : rows_) {
    auto total =
        std::find_if(totals.begin(), totals.end(), [&](const SummaryRow& t) { return t.method == row.method; });
    if (total == totals.end()) total = totals.insert(totals.end(), {"all", row.method, 0, 0, {}, {}});
    *total += row;
  }
  return totals;
}

long ExperimentSummary::errors() const {
  long errors = 0;
  for (const SummaryRow& row : rows_) errors += row.errors;
  return errors;
}

long ExperimentSummary::scored() const {
  long scored = 0;
  for (const SummaryRow& row : rows_) scored += row.frames - row.errors;
  return scored;
}

}  // namespace epcc
