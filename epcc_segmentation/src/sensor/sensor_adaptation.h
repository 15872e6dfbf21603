// SPDX-License-Identifier: BSD-3-Clause
// S0: a given sensor model is pulled to the frames' own error before anything is decided with it.
#pragma once

#include <vector>

#include "epcc_segmentation/sensor_estimation.h"
#include "epcc_segmentation/sensor_model.h"
#include "inverse_depth/inverse_depth_image.h"

namespace epcc {

/// The given model with its error times e^x: x = ln(rho) moved towards zero by a dead zone, rho the median over sampled
/// pixels of the measured to the given sigma. Its correlation length is pulled to the measured model's, with the same
/// dead zone, where the frames contradict it: a preset has that of the sensor's own image, whose pixels are not those
/// of a smaller one. The shape stays, as does the length of scans, and all where nothing could be measured. `ratios` is
/// memory, kept from frame to frame.
SensorModel adapted(const SensorModel& given, const SensorEstimate& measured, const InverseDepthImage& image,
                    std::vector<double>& ratios);

}  // namespace epcc
