// SPDX-License-Identifier: BSD-3-Clause
// Files are known by their names.
#include "eval/track/earlier_run.h"

#include <filesystem>
#include <set>

#include "datasets/support/folder_listing.h"

namespace epcc {
namespace {

namespace fs = std::filesystem;

constexpr const char* kPictureEndings[] = {"_labels.png", "_overlay.png"};
constexpr const char* kWholeRun[] = {"tracks.json", "trajectory.txt", "map.ply", "map.png", "times.csv"};

/// What stays because it cannot be removed, or is no file, cannot be written either.
void removeFile(const fs::path& path) {
  std::error_code ignored;
  if (fs::is_regular_file(fs::symlink_status(path, ignored))) fs::remove(path, ignored);
}

}  // namespace

std::string foreignPicture(const std::string& folder, const std::vector<std::string>& frames) {
  std::error_code ignored;
  if (!fs::is_directory(folder, ignored)) return {};
  const std::set<std::string> own(frames.begin(), frames.end());
  for (const char* ending : kPictureEndings)
    for (const std::string& name : filesEndingIn(folder, ending))
      if (own.count(name) == 0) return name + ending;
  return {};
}

std::vector<std::string> filesOfRun(const std::string& folder) {
  std::vector<std::string> files;
  for (const char* name : kWholeRun) files.push_back((fs::path(folder) / name).string());
  return files;
}

void removeEarlierRun(const std::string& folder, const std::vector<std::string>& frames) {
  for (const std::string& file : filesOfRun(folder)) removeFile(file);
  for (const std::string& frame : frames)
    for (const char* ending : kPictureEndings) removeFile(fs::path(folder) / (frame + ending));
}

}  // namespace epcc
