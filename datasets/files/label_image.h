// SPDX-License-Identifier: BSD-3-Clause
// The label image that any segmentation is written as.
#pragma once

#include <string>

#include "epcc_segmentation/plane_segmentation.h"

namespace epcc {

/// 16-bit grey PNG, 0 = no plane. Throws OutputError, also if there are more planes than it can hold.
void writeLabelImage(const std::string& path, const PlaneSegmentation& segmentation);

}  // namespace epcc
