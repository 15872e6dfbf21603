// SPDX-License-Identifier: BSD-3-Clause
// The line segments of S1 in metres, with the labels that their pixels have in the end.
#pragma once

#include <cstdint>
#include <vector>

#include "epcc_segmentation/depth_frame.h"
#include "epcc_segmentation/line_segment.h"
#include "epcc_segmentation/sensor_model.h"

namespace epcc {

/// Appends the segments of the view's columns. `segment_of` holds each pixel's segment, -1 none, column by column;
/// `labels` are the final ones, in the order of the caller's arrays.
void appendSegments(const DepthFrame& view, const SensorModel& sensor, const std::int32_t* segment_of,
                    const std::vector<std::int32_t>& labels, std::vector<LineSegment>& segments);

}  // namespace epcc
