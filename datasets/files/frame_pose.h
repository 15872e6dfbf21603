// SPDX-License-Identifier: BSD-3-Clause
// Where the camera of a frame stood, for frames of a sequence.
#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "datasets/files/labelled_frame.h"

namespace epcc {

/// Key "pose" of NAME.json: camera to world, 3x4, row-major, as 12 numbers or three rows of four. Nothing if the frame
/// has none; InputError if it is no rotation (to a thousandth) with a translation in metres.
std::optional<Eigen::Isometry3d> framePose(const LabelledFrame& frame);

/// Writes the key.
void setFramePose(const Eigen::Isometry3d& pose, LabelledFrame& frame);

}  // namespace epcc
