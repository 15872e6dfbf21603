// SPDX-License-Identifier: BSD-3-Clause
// Links are followed by hand where their target may not exist yet, and by the library else.
#include "datasets/support/file_place.h"

#include <algorithm>
#include <system_error>

namespace epcc {

namespace fs = std::filesystem;

namespace {

constexpr int kMostLinks = 40;  // as the kernel

/// Links in /proc look like files whose content they do not have.
bool isMadeUp(const fs::path& link) {
  std::error_code ignored;
  return fs::weakly_canonical(link.parent_path(), ignored).string().rfind("/proc/", 0) == 0;
}

}  // namespace

fs::path behindLinks(fs::path path) {
  std::error_code error;
  for (int links = 0; links < kMostLinks && fs::is_symlink(fs::symlink_status(path, error)) && !isMadeUp(path);
       ++links) {
    const fs::path target = fs::read_symlink(path, error);
    if (error) break;
    path = path.parent_path() / target;
  }
  return path;
}

fs::path filePlace(const std::string& path) {
  std::error_code error;
  const fs::path full = fs::absolute(behindLinks(path), error);
  if (error) return path;
  fs::path place = fs::weakly_canonical(full, error);
  if (error) place = full.lexically_normal();
  return place.filename().empty() ? place.parent_path() : place;  // "folder/" is "folder"
}

bool isWithin(const std::string& file, const std::string& folder) {
  const fs::path inner = filePlace(file), outer = filePlace(folder);
  return std::mismatch(outer.begin(), outer.end(), inner.begin(), inner.end()).first == outer.end();
}

}  // namespace epcc
