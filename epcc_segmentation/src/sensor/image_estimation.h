// SPDX-License-Identifier: BSD-3-Clause
// The sensor measured on a frame that has been read, so that nobody reads it twice.
#pragma once

#include "epcc_segmentation/sensor_estimation.h"
#include "inverse_depth/inverse_depth_image.h"

namespace epcc {

/// As estimateSensor(const DepthFrame&); the image need not be weighed.
SensorEstimate estimateSensor(const InverseDepthImage& image);

}  // namespace epcc
