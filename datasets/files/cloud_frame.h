// SPDX-License-Identifier: BSD-3-Clause
// Organized clouds as frames: their points and what was measured.
#pragma once

#include <string>

#include "datasets/files/labelled_frame.h"
#include "datasets/files/organized_pcd.h"

namespace epcc {

/// An unlabelled frame that takes the points out of the cloud: `scan` holds them, `geometry` how they were seen,
/// `depth` their ranges (a scan) or distances along the optical axis (a camera's cloud). A cloud whose geometry is
/// unknown has no depths, and frameView() says why. `is_scan`: it is known to be one.
LabelledFrame cloudFrame(const std::string& name, OrganizedCloud& cloud, bool is_scan);

/// Looks for the geometry of a frame's cloud with other options, and measures its depths anew.
void findCloudGeometry(LabelledFrame& frame, const CloudOptions& options);

/// Reads a .pcd without looking for labels; how it was seen is found out from its points.
LabelledFrame readCloud(const std::string& path);

}  // namespace epcc
