// SPDX-License-Identifier: BSD-3-Clause
// The labelled part of NYU Depth V2, nyu_depth_v2_labeled.mat (HDF5), with plane labels in it or beside it.
#pragma once

#include <memory>
#include <string>

#include "datasets/frame_source.h"

namespace epcc {

/// True for a file NAME.mat and for a folder with nyu_depth_v2_labeled.mat; needs no HDF5.
bool isNyuMat(const std::string& path);

/// Opens such a file or folder. InputError where this build has no HDF5.
std::unique_ptr<FrameSource> openNyuMat(const std::string& path);

}  // namespace epcc
