// SPDX-License-Identifier: BSD-3-Clause
// The library follows links in all parts of a path that are there.
#include "datasets/support/file_place.h"

#include <algorithm>
#include <system_error>

namespace epcc {

namespace fs = std::filesystem;

fs::path filePlace(const std::string& path) {
  std::error_code error;
  const fs::path full = fs::absolute(path, error);
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
