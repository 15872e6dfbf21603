// SPDX-License-Identifier: BSD-3-Clause
// The line segments of a frame on its depth, as in the paper's Figure 14.
#pragma once

#include <vector>

#include "datasets/files/image.h"
#include "epcc_segmentation/line_segment.h"

namespace epcc {

/// The segments of scan lines six pixels apart, or more if the list has no such line, on the dimmed relief of the
/// depth: in the colour of their plane, those of no plane in black and white by turns; a dark pixel marks the end. Of
/// two scan directions both are drawn, as a grid. `segments` are in the order of PlaneSegmentation::segments. Throws
/// std::invalid_argument if a segment lies outside.
ColorImage drawSegments(const DepthImage& depth, const std::vector<LineSegment>& segments);

}  // namespace epcc
