// SPDX-License-Identifier: BSD-3-Clause
// Lists and reads a folder of native frames.
#include "datasets/native_folder.h"

#include "datasets/dataset_registry.h"
#include "datasets/input_error.h"

namespace epcc {

NativeFolder::NativeFolder(const std::string& folder)
    : folder_(folder), dataset_(folderName(folder)), names_(listLabelledFrames(folder)) {
  if (names_.empty()) throw InputError(folder, "folder", "has no frame NAME_depth.png");
}

LabelledFrame NativeFolder::read(std::size_t index) const {
  return readLabelledFrame(folder_, names_.at(index));
}

}  // namespace epcc
