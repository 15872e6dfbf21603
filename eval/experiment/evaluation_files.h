// SPDX-License-Identifier: BSD-3-Clause
// Label images and pictures of the frames that epcc_eval has done.
#pragma once

#include <string>
#include <vector>

#include "eval/experiment/experiment.h"

namespace epcc {

/// OUT/labels/METHOD/NAME_labels.png of every method that had no error; of the others none is left. Throws OutputError.
void writeLabelImages(const std::string& out, const FrameResult& result);
/// OUT/overlays/NAME.png: depth, truth and every method side by side; of a frame that could not be read none is left.
/// Throws OutputError.
void writeOverlays(const std::string& out, const FrameResult& result);

}  // namespace epcc
