// SPDX-License-Identifier: BSD-3-Clause
// The mesh and the polygons that epcc_segment writes.
#pragma once

#include "epcc_segmentation/depth_frame.h"
#include "eval/segment/segment_output.h"

namespace epcc {

/// Writes those that the paths name; does nothing if they name none. Throws OutputError.
void writeSurfaces(const OutputPaths& paths, const DepthFrame& frame, const PlaneSegmentation& result,
                   const SurfaceStyle& style);

}  // namespace epcc
