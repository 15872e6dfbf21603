// SPDX-License-Identifier: BSD-3-Clause
// The folder's frames are listed once and read one by one, by the functions of labelled_frame.h.
#include "datasets/sources/native_folder.h"

namespace epcc {

NativeFolder::NativeFolder(const std::string& folder)
    : NamedFrames(folder, listLabelledFrames(folder), "frame NAME_depth.png or NAME.pcd with NAME.json") {}

std::vector<std::string> NativeFolder::files(std::size_t index) const {
  return {labelledFrameFile(folder(), name(index)), path(index, ".json"), path(index, "_labels.png")};
}

LabelledFrame NativeFolder::read(std::size_t index) const {
  return readLabelledFrame(folder(), name(index));
}

}  // namespace epcc
