// SPDX-License-Identifier: BSD-3-Clause
// The list of a frame's line segments as CSV.
#pragma once

#include <string>
#include <vector>

#include "epcc_segmentation/line_segment.h"

namespace epcc {

/// A heading with units, then a line for each segment; numbers with as many digits as it takes to read them back
/// exactly. The columns are explained in docs/reference/formats.md.
std::string segmentListCsv(const std::vector<LineSegment>& segments);
void writeSegmentList(const std::string& path, const std::vector<LineSegment>& segments);

}  // namespace epcc
