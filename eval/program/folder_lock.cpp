// SPDX-License-Identifier: BSD-3-Clause
// A lock of a file in the folder: it is seen by other machines, too, where the file system has locks.
#include "eval/program/folder_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <filesystem>
#include <thread>

#include "datasets/support/input_error.h"
#include "datasets/support/output_folder.h"

namespace epcc {

namespace {

/// The processes of a run with a time limit for frames (timed_experiment.h) hold the lock with it. When it is killed
/// they are, too, but a moment later.
constexpr std::chrono::milliseconds kPatience(2000), kPause(20);

/// File systems without locks are used without.
bool isTaken(int file) {
  const auto end = std::chrono::steady_clock::now() + kPatience;
  while (flock(file, LOCK_EX | LOCK_NB) != 0) {
    if (errno == EINTR) continue;
    if (errno != EWOULDBLOCK) return true;
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(kPause);
  }
  return true;
}

}  // namespace

FolderLock::FolderLock(const std::string& folder) {
  makeOutputFolder(folder);
  file_ = open((std::filesystem::path(folder) / ".epcc-lock").c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0666);
  if (file_ < 0 || isTaken(file_)) return;
  close(file_);
  throw OutputError(folder, "folder", "another process is at work in it");
}

FolderLock::~FolderLock() {
  if (file_ >= 0) close(file_);
}

}  // namespace epcc
