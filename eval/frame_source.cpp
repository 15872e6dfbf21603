// SPDX-License-Identifier: BSD-3-Clause
// Lists and reads folders of native frames and of SynPEB scans.
#include "eval/frame_source.h"

#include <filesystem>

#include "datasets/input_error.h"
#include "datasets/synpeb.h"

namespace epcc {

namespace fs = std::filesystem;

std::string folderName(const std::string& folder) {
  std::error_code error;
  fs::path path = fs::weakly_canonical(fs::absolute(folder), error);
  if (error) path = fs::path(folder);
  if (path.filename().empty()) path = path.parent_path();
  return path.filename().empty() ? "root" : path.filename().string();
}

NativeFolder::NativeFolder(const std::string& folder)
    : folder_(folder), dataset_(folderName(folder)), names_(listLabelledFrames(folder)) {
  if (names_.empty()) throw InputError(folder, "folder", "has no frame NAME_depth.png");
}

LabelledFrame NativeFolder::read(std::size_t index) const {
  return readLabelledFrame(folder_, names_.at(index));
}

SynpebFolder::SynpebFolder(const std::string& folder)
    : folder_(folder), dataset_(folderName(folder)), names_(listSynpebScans(folder)) {
  if (names_.empty()) throw InputError(folder, "folder", "has no scan NAME.pcd");
}

LabelledFrame SynpebFolder::read(std::size_t index) const {
  return readSynpebScan(folder_, names_.at(index));
}

}  // namespace epcc
