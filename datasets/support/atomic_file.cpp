// SPDX-License-Identifier: BSD-3-Clause
// A file is written beside its target under a hidden name, and renamed when it is complete.
#include "datasets/support/atomic_file.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <random>

#include "datasets/support/input_error.h"

namespace epcc {

namespace fs = std::filesystem;

namespace {

constexpr const char* kPrefix = ".epcc-";
constexpr const char* kSuffix = ".tmp";

/// A hidden name in the same folder that no other process, on this machine or another, uses at the same time. It does
/// not grow with the target's name, which may be as long as the file system allows.
std::string temporaryName(const fs::path& folder) {
  std::random_device random;
  std::string name = kPrefix;
  for (int i = 0; i < 4; ++i) name += std::to_string(random()) + (i < 3 ? "-" : kSuffix);
  return (folder / name).string();
}

}  // namespace

void checkOutputFile(const std::string& path) {
  std::error_code code;
  const fs::path folder = fs::path(path).parent_path();
  const fs::file_status of_folder = fs::status(folder.empty() ? "." : folder, code);
  if (of_folder.type() == fs::file_type::none) throw OutputError(path, "folder", code.message());
  if (!fs::is_directory(of_folder)) throw OutputError(path, "folder", "does not exist");
  const fs::file_status status = fs::symlink_status(path, code);
  if (fs::is_directory(status)) throw OutputError(path, "file", "is a folder");
  if (fs::is_symlink(status)) throw OutputError(path, "file", "is a symbolic link");
  if (fs::exists(status) && !fs::is_regular_file(status)) throw OutputError(path, "file", "is not a regular file");
}

void writeAtomically(const std::string& path, const std::function<void(const std::string& temporary)>& write) {
  checkOutputFile(path);
  const std::string temporary = temporaryName(fs::path(path).parent_path());
  std::error_code code;
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

void removeTemporaries(const std::string& folder, bool below) {
  std::error_code code;
  fs::recursive_directory_iterator entry(folder, code);
  for (const fs::recursive_directory_iterator end; !code && entry != end; entry.increment(code)) {
    if (!below) entry.disable_recursion_pending();
    const std::string name = entry->path().filename().string();
    if (name.rfind(kPrefix, 0) != 0 || entry->path().extension() != kSuffix) continue;
    std::error_code ignored;
    fs::remove(entry->path(), ignored);
  }
}

}  // namespace epcc
