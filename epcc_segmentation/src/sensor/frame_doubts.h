// SPDX-License-Identifier: BSD-3-Clause
// The doubts about a frame that has been read.
#pragma once

#include <vector>

#include "epcc_segmentation/doubts.h"
#include "epcc_segmentation/sensor_estimation.h"
#include "inverse_depth/scattered_pixels.h"

namespace epcc {

/// How large the measured error is, as a share of the image's median depth; 0 where nothing was measured. `depths` is
/// memory.
double errorShare(const InverseDepthImage& image, const SensorEstimate& measured, std::vector<double>& depths);

/// Sets what is read off the depths alone: jump_share, limit_share and limit_depth.
void doubtDepths(const InverseDepthImage& image, Doubts& doubts);

}  // namespace epcc
