// SPDX-License-Identifier: BSD-3-Clause
// Write beside the target, then rename.
#include "datasets/atomic_file.h"

#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "datasets/input_error.h"

namespace epcc {

void writeAtomically(const std::string& path, const std::function<void(const std::string& temporary)>& write) {
  namespace fs = std::filesystem;
  static std::atomic<unsigned> counter{0};
  std::error_code code;
  const fs::path folder = fs::path(path).parent_path();
  if (!folder.empty() && !fs::is_directory(folder, code)) throw OutputError(path, "folder", "does not exist");
  if (fs::is_directory(path, code)) throw OutputError(path, "file", "is a folder");
  const std::string temporary = path + ".tmp" + std::to_string(::getpid()) + "." + std::to_string(counter++);
  try {
    write(temporary);
    fs::rename(temporary, path, code);
    if (code) throw OutputError(path, "file", code.message());
  } catch (...) {
    std::error_code ignored;
    fs::remove(temporary, ignored);
    throw;
  }
}

void writeTextFile(const std::string& path, const std::string& text) {
  writeAtomically(path, [&](const std::string& temporary) {
    std::ofstream out(temporary, std::ios::binary);
    out << text;
    out.close();
    if (!out) throw OutputError(path, "file", std::strerror(errno));
  });
}

}  // namespace epcc
