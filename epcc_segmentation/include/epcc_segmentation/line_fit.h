// SPDX-License-Identifier: BSD-3-Clause
// Least-squares line segments of the labelled pixels.
#pragma once

#include "epcc_segmentation/depth_frame.h"
#include "epcc_segmentation/export.h"
#include "epcc_segmentation/parameters.h"
#include "epcc_segmentation/plane_segmentation.h"
#include "epcc_segmentation/sensor_model.h"

namespace epcc {

/// Fills segmentation.segments from its labels, true ones for instance: in each column, row or both, what is in
/// sequence of one label that is not 0 is a segment if it has three measured pixels; pixels that are not measured end
/// nothing. The covariance of the segments' parameters takes the error to be correlated as the sensor model says. A
/// spherical scan has no rows. False, with no segments, if there is not one label for every pixel of the frame, or the
/// frame is empty.
EPCC_CORE_EXPORT bool fitLines(const DepthFrame& frame, const SensorModel& sensor, ScanDirection scan,
                               PlaneSegmentation& segmentation);

}  // namespace epcc
