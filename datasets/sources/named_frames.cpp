// SPDX-License-Identifier: BSD-3-Clause
// Puts paths together from the names of the frames, of which there must be some.
#include "datasets/sources/named_frames.h"

#include <filesystem>
#include <utility>

#include "datasets/support/folder_listing.h"
#include "datasets/support/input_error.h"

namespace epcc {

NamedFrames::NamedFrames(const std::string& folder, std::vector<std::string> names, const std::string& kind)
    : folder_(folder), dataset_(folderName(folder)), names_(std::move(names)) {
  if (names_.empty()) throw InputError(folder, "folder", "has no " + kind);
}

std::string NamedFrames::path(std::size_t index, const std::string& ending) const {
  return existingFile((std::filesystem::path(folder_) / (names_.at(index) + ending)).string());
}

}  // namespace epcc
