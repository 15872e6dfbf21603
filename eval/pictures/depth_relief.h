// SPDX-License-Identifier: BSD-3-Clause
// Brightness of a depth image seen as a lit relief.
#pragma once

#include <vector>

#include "datasets/files/image.h"

namespace epcc {

/// Brightness 0..1 a pixel, negative where the depth is invalid.
std::vector<float> depthRelief(const DepthImage& depth);

}  // namespace epcc
