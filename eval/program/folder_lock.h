// SPDX-License-Identifier: BSD-3-Clause
// One process at a time works in a folder of outputs.
#pragma once

#include <string>

namespace epcc {

/// Holds the folder for one process for as long as the object lives; the lock, of the file .epcc-lock, goes with the
/// process, however it ends.
class FolderLock {
 public:
  /// Makes the folder. Throws OutputError if that fails, or another process works there.
  explicit FolderLock(const std::string& folder);
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;
  ~FolderLock();

 private:
  int file_ = -1;
};

}  // namespace epcc
