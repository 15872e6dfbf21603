// SPDX-License-Identifier: BSD-3-Clause
// Pictures of a depth image and of the labels on it; plain pixels, no OpenGL.
#pragma once

#include <cstdint>
#include <vector>

#include "datasets/files/image.h"

namespace epcc {

/// How an overlay looks.
struct OverlayStyle {
  /// Share of the label's colour. [0, 1]
  double opacity = 0.75;
  /// Dark line between regions.
  bool borders = true;
};

/// The depth image as a relief: surfaces lit by their slope, nearer ones brighter. Invalid pixels are near black.
/// No camera is needed; the relief is for looking at, not for measuring.
ColorImage shadeDepth(const DepthImage& depth);

/// Labels on the relief: 0 stays grey, plane k has labelColor(k). `labels` is row-major with one entry a pixel
/// of `depth`; throws std::invalid_argument if it has not.
ColorImage drawOverlay(const DepthImage& depth, const std::vector<std::int32_t>& labels,
                       const OverlayStyle& style = OverlayStyle());
ColorImage drawOverlay(const DepthImage& depth, const LabelImage& labels, const OverlayStyle& style = OverlayStyle());

}  // namespace epcc
