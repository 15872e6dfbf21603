// SPDX-License-Identifier: BSD-3-Clause
// The errors of a run by name, as many as a reader can use.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "eval/experiment/experiment.h"

namespace epcc {

/// A line for each error of a frame; a frame that cannot be read is one problem, not one for each method.
std::vector<std::string> frameProblems(const std::vector<FrameRecord>& records);

/// "2 errors, 5 results scored"; empty if there are no errors.
std::string countsOfErrors(long errors, long scored);

/// 3 if nothing was scored or, with `strict`, there is any error; else 0.
int exitCodeOf(long errors, long scored, bool strict);

/// Keeps the first thousand and counts the rest: every error is in frames.csv.
class ProblemList {
 public:
  void add(const std::string& problem);
  /// The lines and, where there were too many, how many more.
  std::vector<std::string> lines() const;

 private:
  std::vector<std::string> first_;
  std::size_t count_ = 0;
};

}  // namespace epcc
