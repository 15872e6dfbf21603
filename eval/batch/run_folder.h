// SPDX-License-Identifier: BSD-3-Clause
// The folder of a run: who may work in it, and whether it fits the run.
#pragma once

#include <string>

#include "eval/batch/run_description.h"
#include "eval/program/folder_lock.h"

namespace epcc {

/// Holds OUT for one process for as long as the object lives.
class RunFolder {
 public:
  /// Makes the folder. Throws OutputError if that fails or another process works there.
  explicit RunFolder(const std::string& out);

  /// Begins a run or, with `resume`, goes on with it. Returns why it cannot, in words: there are results already, or
  /// they are those of another run. Throws InputError for a damaged run.json.
  std::string begin(const RunDescription& run, bool resume);

  /// Why no report of other folders' results may be written here, in words: the folder has results of its own. Empty if
  /// it has none.
  std::string refuseRun() const;

  /// Removes what processes that were killed have left half written. Nobody may be writing here.
  void removeLeftovers() const;

 private:
  std::string out_;
  FolderLock lock_;
};

}  // namespace epcc
