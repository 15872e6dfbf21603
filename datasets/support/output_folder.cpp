// SPDX-License-Identifier: BSD-3-Clause
// What counts is that the folder is there in the end: another process may make it at the same time.
#include "datasets/support/output_folder.h"

#include <filesystem>

#include "datasets/support/atomic_file.h"
#include "datasets/support/input_error.h"

namespace epcc {

void makeOutputFolder(const std::string& folder) {
  std::error_code error, ignored;
  std::filesystem::create_directories(folder, error);
  if (!std::filesystem::is_directory(folder, ignored))
    throw OutputError(folder, "folder", "cannot be made" + (error ? ", " + error.message() : std::string()));
}

void makeOutputFolder(const std::string& folder, const std::vector<std::string>& files) {
  makeOutputFolder(folder);
  for (const std::string& file : files) checkOutputFile((std::filesystem::path(folder) / file).string());
}

}  // namespace epcc
