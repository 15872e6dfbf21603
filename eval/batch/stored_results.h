// SPDX-License-Identifier: BSD-3-Clause
// The results of a run, or of all shards of one, frame after frame in a fixed order.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "eval/batch/run_description.h"
#include "eval/batch/stored_frame.h"

namespace epcc {

/// Reads one frame at a time: memory does not grow with their number.
class StoredResults {
 public:
  /// The results of one run or shard, on their own.
  StoredResults(const std::string& folder, const RunDescription& run);

  /// Folders of runs that are parts of one: shards, or runs over different data sets. Throws InputError, in one line,
  /// where options differ or a shard is missing or given twice.
  static StoredResults merged(const std::vector<std::string>& folders);

  /// `shard` and single data sets aside, what the run over everything would be.
  const RunDescription& run() const { return run_; }

  /// By data set, then by frame, with the folder that holds the frame. Throws InputError, in one line, if results are
  /// missing; it says so after the last frame.
  using Visit = std::function<void(const StoredFrame& frame, const std::string& folder)>;
  void forEach(const Visit& visit) const;

 private:
  /// Where a data set's frames are.
  struct Owners {
    std::size_t start = 0;             ///< position of its first frame in the run that named it first
    std::vector<std::string> folders;  ///< by index modulo their number; an empty one is not at hand
  };

  StoredResults() = default;
  void add(const std::string& folder, const RunDescription& run);
  Owners& ownersOf(const RunDataset& dataset, std::size_t start, const std::string& folder, std::size_t shards);
  void requireAllShards() const;

  RunDescription run_;
  std::vector<Owners> owners_;  ///< by data set
};

}  // namespace epcc
