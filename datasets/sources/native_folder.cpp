// SPDX-License-Identifier: BSD-3-Clause
// Lists and reads a folder of native frames.
#include "datasets/sources/native_folder.h"

namespace epcc {

NativeFolder::NativeFolder(const std::string& folder)
    : NamedFrames(folder, listLabelledFrames(folder), "frame NAME_depth.png") {}

LabelledFrame NativeFolder::read(std::size_t index) const {
  return readLabelledFrame(folder(), name(index));
}

}  // namespace epcc
