// SPDX-License-Identifier: BSD-3-Clause
// Organized clouds as frames: their points and what was measured.
#pragma once

#include <string>

#include "datasets/files/labelled_frame.h"
#include "datasets/files/organized_pcd.h"

namespace epcc {

/// An unlabelled frame that takes the points out of the cloud: `scan` holds them, `depth` their ranges (a scan) or
/// distances along the optical axis (a camera's cloud).
LabelledFrame cloudFrame(const std::string& name, OrganizedCloud&& cloud, Projection projection);

/// Reads a .pcd without looking for labels; how it was seen is found out from its points.
LabelledFrame readCloud(const std::string& path);

}  // namespace epcc
