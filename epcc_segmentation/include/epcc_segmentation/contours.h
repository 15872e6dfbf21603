// SPDX-License-Identifier: BSD-3-Clause
// The outlines of the regions of a label image: outer borders and holes, in pixels.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "epcc_segmentation/export.h"

namespace epcc {

/// One border of a region, a closed walk through the region's own pixels.
///
/// Consecutive points, and the last and the first, are 8-neighbours. A walk along a part one pixel
/// wide goes there and back, so that a pixel may occur more than once; a single pixel gives one point.
/// Seen on the picture (columns to the right, rows down) outer borders run counter-clockwise and
/// hole borders clockwise: the region lies to the left of the walk.
struct PixelContour {
  std::vector<Eigen::Vector2i> points;  ///< (column, row), closed implicitly
  bool is_hole = false;                 ///< Border of a hole; its points are the region's pixels around the hole.
};

/// Borders of the region of pixels with the given label.
///
/// The region's pixels connect to their 8 neighbours, what lies in its holes to 4 neighbours; every
/// other label counts as background, and so does the outside of the image. A region in several pieces
/// has several outer borders; a piece inside a hole has an outer border of its own. The order is: outer
/// borders, the one that encloses the largest area first, then the holes likewise; equal areas in the
/// order of the first point from top to bottom and left to right.
///
/// `labels` is row-major, width * height values; the result is empty if it is shorter, or label is 0
/// or negative. One pass over the image plus the length of the borders.
EPCC_CORE_EXPORT std::vector<PixelContour> traceContours(const std::vector<std::int32_t>& labels, int width, int height,
                                                         std::int32_t label);

/// The borders of the labels 1..label_count in one pass over the image: [k] holds those of label k + 1,
/// as traceContours() gives them. Labels outside 1..label_count are background.
EPCC_CORE_EXPORT std::vector<std::vector<PixelContour>> traceAllContours(const std::vector<std::int32_t>& labels,
                                                                         int width, int height, int label_count);

/// Area inside the polygon through the points, in pixels: positive for an outer border, negative for a hole,
/// zero for one without an inside (a line of pixels).
EPCC_CORE_EXPORT double signedArea(const PixelContour& contour);

}  // namespace epcc
