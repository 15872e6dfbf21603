// SPDX-License-Identifier: BSD-3-Clause
// Scenes in the layout that ScanNet's SensReader exports, with plane label pictures.
#pragma once

#include <memory>
#include <string>

#include "datasets/sources/frame_source.h"

namespace epcc {

/// True if there are depth/ and intrinsic/intrinsic_depth.txt.
bool isScannetFolder(const std::string& folder);

/// depth/N.png in millimetres, the camera from intrinsic/intrinsic_depth.txt; labels in planes/, labels/ or
/// annotation/segmentation/, the first that is there.
std::unique_ptr<FrameSource> openScannetFolder(const std::string& folder);

}  // namespace epcc
