// SPDX-License-Identifier: BSD-3-Clause
// Files that no disk slows down.
#pragma once

#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>
#include <string>

namespace epcc::test {

/// A file in memory that this process can open by a path.
class MemoryFile {
 public:
  MemoryFile() : descriptor_(::memfd_create("epcc-test", 0)), path_("/proc/self/fd/" + std::to_string(descriptor_)) {}
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  ~MemoryFile() { ::close(descriptor_); }

  const std::string& path() const { return path_; }
  /// The file holds these bytes from now on; false if that failed.
  bool fill(const void* bytes, std::size_t size) const {
    return ::ftruncate(descriptor_, 0) == 0 && ::pwrite(descriptor_, bytes, size, 0) == static_cast<ssize_t>(size);
  }
  bool fill(const std::string& bytes) const { return fill(bytes.data(), bytes.size()); }

 private:
  int descriptor_;
  std::string path_;
};

}  // namespace epcc::test
