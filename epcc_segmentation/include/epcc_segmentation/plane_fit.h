// SPDX-License-Identifier: BSD-3-Clause
// Least-squares planes of the labelled pixels.
#pragma once

#include "epcc_segmentation/depth_frame.h"
#include "epcc_segmentation/export.h"
#include "epcc_segmentation/plane_segmentation.h"
#include "epcc_segmentation/sensor_model.h"

namespace epcc {

/// Fills segmentation.planes from its labels 1..plane_count: orthogonal least squares, then one step of least squares
/// along the rays, the depths weighted by 1 / sigma_z^2 at the plane's own depth, which errors of the depths do not
/// bias. Then sorts planes and labels by pixel count, largest first, and drops labels without pixels. Any other label
/// counts as 0 and becomes it. False, with no planes and the labels as they were, if there is not one label for every
/// pixel of the frame or the count is negative.
EPCC_CORE_EXPORT bool fitPlanes(const DepthFrame& frame, const SensorModel& sensor, int plane_count,
                                PlaneSegmentation& segmentation);

}  // namespace epcc
