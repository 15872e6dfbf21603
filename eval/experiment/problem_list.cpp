// SPDX-License-Identifier: BSD-3-Clause
// The same problem of many methods is told once; only so many lines are printed.
#include "eval/experiment/problem_list.h"

#include "eval/program/command_line.h"

namespace epcc {

namespace {
constexpr std::size_t kMaxLines = 1000;
}  // namespace

std::vector<std::string> frameProblems(const std::vector<FrameRecord>& records) {
  std::vector<std::string> lines;
  std::string last;
  for (const FrameRecord& record : records) {
    if (!record.error.empty() && record.error != last)
      lines.push_back(record.dataset + "/" + record.frame + ": " + record.method + ": " + record.error);
    last = record.error;
  }
  return lines;
}

std::string countsOfErrors(long errors, long scored) {
  if (errors == 0) return "";
  return std::to_string(errors) + (errors == 1 ? " error, " : " errors, ") + std::to_string(scored) +
         (scored == 1 ? " result scored" : " results scored");
}

int exitCodeOf(long errors, long scored, bool strict) {
  if (scored == 0) return kExitInput;
  return strict && errors > 0 ? kExitInput : kExitDone;
}

void ProblemList::add(const std::string& problem) {
  if (count_++ < kMaxLines) first_.push_back(problem);
}

std::vector<std::string> ProblemList::lines() const {
  std::vector<std::string> lines = first_;
  if (count_ > first_.size())
    lines.push_back("and " + std::to_string(count_ - first_.size()) + " more: see frames.csv");
  return lines;
}

}  // namespace epcc
