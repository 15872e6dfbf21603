// SPDX-License-Identifier: BSD-3-Clause
// One process at a time works in the folder (a lock), on the run it was begun for (a comparison with run.json); what a
// killed one left half written is removed.
#include "eval/batch/run_folder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <filesystem>
#include <thread>

#include "datasets/support/atomic_file.h"
#include "datasets/support/input_error.h"
#include "datasets/support/output_folder.h"

namespace epcc {

namespace fs = std::filesystem;

namespace {

/// The processes of a run with a time limit for frames (timed_experiment.h) hold the lock with it. When it is killed
/// they are, too, but a moment later.
constexpr std::chrono::milliseconds kLockPatience(2000), kLockPause(20);

/// File systems without locks are used without.
bool isTaken(int lock) {
  const auto end = std::chrono::steady_clock::now() + kLockPatience;
  while (flock(lock, LOCK_EX | LOCK_NB) != 0) {
    if (errno == EINTR) continue;
    if (errno != EWOULDBLOCK) return true;
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(kLockPause);
  }
  return true;
}

}  // namespace

RunFolder::RunFolder(const std::string& out) : out_(out) {
  makeOutputFolder(out);
  lock_ = open((fs::path(out) / ".epcc-lock").c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0666);
  if (lock_ < 0 || isTaken(lock_)) return;
  close(lock_);
  throw OutputError(out, "folder", "another epcc_eval is at work in it");
}

RunFolder::~RunFolder() {
  if (lock_ >= 0) close(lock_);
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
