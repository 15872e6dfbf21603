// SPDX-License-Identifier: BSD-3-Clause
// The grid of samples that S1 to S9 work on, and what the parameters are on it.
#pragma once

#include "epcc_segmentation/inverse_depth_parameters.h"
#include "epcc_segmentation/sensor_model.h"
#include "inverse_depth/grid_steps.h"

namespace epcc {

/// The longer side of an image that counts as at most twice as wide as high: the faces in a scan of 64 rings are as few
/// samples high as those in an image of 128 columns, however finely it resolves the azimuth.
int longerSide(int width, int height);

/// The stride itself, or the default for an image of this longer side: one for every 320 pixels, 1 to 4. The sensor's
/// error is correlated, and where it is not it is small faces, not the number of samples, that limit what is found.
int strideFor(int longer_side, int stride);

/// Parameters in samples of the grid, from those in pixels. What counts independent samples, ratios or sigma stays. The
/// expert's lengths are pixels of an image whose longer side is 640: in a smaller one, where the same face is fewer
/// pixels wide, they are divided by up to four. min_points is the user's and stays what it says.
InverseDepthParameters onGrid(const InverseDepthParameters& parameters, int longer_side, const GridSteps& steps);
/// The sensor's error with its correlation length in samples.
SensorModel onGrid(const SensorModel& sensor, const GridSteps& steps);

}  // namespace epcc
