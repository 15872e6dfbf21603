// SPDX-License-Identifier: BSD-3-Clause
// A clustered line in the form in which the result shows it.
#pragma once

#include "epcc_segmentation/depth_frame.h"
#include "epcc_segmentation/line_segment.h"
#include "metric/clustered_line.h"

namespace epcc {

/// Of a line of the view's column `column`, in the caller's pixels and frame; without a label.
LineSegment lineSegmentOf(const DepthFrame& view, int column, const ClusteredLine& line);

}  // namespace epcc
