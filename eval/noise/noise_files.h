// SPDX-License-Identifier: BSD-3-Clause
// What epcc_noise writes.
#pragma once

#include <string>

#include "datasets/files/image.h"
#include "epcc_segmentation/sensor_estimation.h"

namespace epcc {

/// NAME.json: what was measured; its key "noise" is the model, as in the JSON of a frame.
std::string noiseJson(const SensorMeasurement& measured, std::size_t frames);

/// NAME.png: residual against depth and autocorrelation, each with the fit.
ColorImage noisePicture(const SensorMeasurement& measured);

}  // namespace epcc
