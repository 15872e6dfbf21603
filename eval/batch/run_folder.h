// SPDX-License-Identifier: BSD-3-Clause
// The folder of a run: who may work in it, and whether it fits the run.
#pragma once

#include <string>

#include "eval/batch/run_description.h"

namespace epcc {

/// Holds OUT for one process for as long as the object lives; the lock goes with the process, however it ends.
class RunFolder {
 public:
  /// Makes the folder. Throws OutputError if that fails or another process works there.
  explicit RunFolder(const std::string& out);
  RunFolder(const RunFolder&) = delete;
  RunFolder& operator=(const RunFolder&) = delete;
  ~RunFolder();

  /// Begins a run or, with `resume`, goes on with it. Returns why it cannot, in words: there are results already, or
  /// they are those of another run. Throws InputError for a damaged run.json.
  std::string begin(const RunDescription& run, bool resume);

  /// Removes what processes that were killed have left half written. Nobody may be writing here.
  void removeLeftovers() const;

 private:
  std::string out_;
  int lock_ = -1;
};

}  // namespace epcc
