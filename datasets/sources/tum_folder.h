// SPDX-License-Identifier: BSD-3-Clause
// Sequences of the TUM RGB-D benchmark and of ICL-NUIM in its layout, with plane labels such as those of EVOPS.
#pragma once

#include <memory>
#include <string>

#include "datasets/sources/frame_source.h"

namespace epcc {

/// True if there is a folder depth/ beside rgb/, associations.txt or depth.txt.
bool isTumFolder(const std::string& folder);

/// The camera is told by the folder's name (freiburg1, fr2, icl, living_room, ...); InputError if it tells none.
std::unique_ptr<FrameSource> openTumFolder(const std::string& folder);
std::unique_ptr<FrameSource> openTumFreiburg1(const std::string& folder);
std::unique_ptr<FrameSource> openTumFreiburg2(const std::string& folder);
std::unique_ptr<FrameSource> openTumFreiburg3(const std::string& folder);
std::unique_ptr<FrameSource> openIclFolder(const std::string& folder);

}  // namespace epcc
