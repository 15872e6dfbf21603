// SPDX-License-Identifier: BSD-3-Clause
// Smooth random fields: the blotches of a depth sensor's error.
#pragma once

#include "datasets/files/image.h"
#include "datasets/support/scene_random.h"

namespace epcc {

/// Gaussian field of zero mean and unit variance whose autocorrelation is exp(-r^2 / (2 length^2)), length in pixels;
/// white for a length below half a pixel.
Image<float> noiseField(int width, int height, double length, SceneRandom& random);

/// The value above which the given share (0..1) of an image's pixels lies; +infinity for a share of zero.
float upperQuantile(const Image<float>& image, double share);

}  // namespace epcc
