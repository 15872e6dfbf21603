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

void removeEarlierRun(const std::string& folder, const std::vector<std::string>& frames) {
  std::error_code ignored;  // what stays because it cannot be removed cannot be written either
  for (const char* name : kWholeRun) fs::remove(fs::path(folder) / name, ignored);
  for (const std::string& frame : frames)
    for (const char* ending : kPictureEndings) fs::remove(fs::path(folder) / (frame + ending), ignored);
}

}  // namespace epcc
