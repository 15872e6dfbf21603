// SPDX-License-Identifier: BSD-3-Clause
// One process at a time works in the folder (a lock), on the run it was begun for (a comparison with run.json); what a
// killed one left half written is removed.
#include "eval/batch/run_folder.h"

#include <filesystem>

#include "datasets/support/atomic_file.h"

namespace epcc {

namespace fs = std::filesystem;

RunFolder::RunFolder(const std::string& out) : out_(out), lock_(out) {}

std::string RunFolder::refuseRun() const {
  std::error_code ignored;
  const bool has_run = fs::exists(runDescriptionPath(out_), ignored) || fs::exists(fs::path(out_) / "results", ignored);
  return has_run ? out_ + " has results of its own; choose another --out" : std::string();
}

std::string RunFolder::begin(const RunDescription& run, bool resume) {
  std::error_code ignored;
  const bool has_run = fs::exists(runDescriptionPath(out_), ignored);
  const bool has_results = fs::exists(fs::path(out_) / "results", ignored);
  if ((has_run || has_results) && !resume)
    return out_ + " has results already; go on with --resume, or choose another --out";
  if (!has_run && has_results) return out_ + " has results but no run.json that tells what they are";
  if (has_run) {
    const RunDescription before = readRunDescription(out_);
    std::string difference = optionDifference(before, run);
    if (difference.empty() && before.shard.text() != run.shard.text())
      difference = "--shard was " + before.shard.text() + ", is " + run.shard.text();
    if (difference.empty()) difference = datasetDifference(before, run);
    if (difference.empty() && before.unusable != run.unusable) difference = "other data sets could not be used";
    if (!difference.empty()) return "--resume: " + out_ + " holds another run: " + difference;
    removeLeftovers();
  }
  writeRunDescription(out_, run);
  return "";
}

void RunFolder::removeLeftovers() const {
  removeTemporaries(out_, false);
  for (const char* folder : {"results", "labels", "overlays", "pictures"})
    removeTemporaries((fs::path(out_) / folder).string(), true);
}

}  // namespace epcc
