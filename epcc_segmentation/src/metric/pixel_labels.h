// SPDX-License-Identifier: BSD-3-Clause
// Each pixel's label from the number of its line segment.
#pragma once

#include <cstddef>
#include <cstdint>

#include "epcc_segmentation/depth_frame.h"

namespace epcc {

/// labels[view.index(row, column)] = label_of[numbers[row * stride + column]] for every pixel of the view.
void labelOfNumbers(const DepthFrame& view, const std::int32_t* numbers, std::size_t stride,
                    const std::int32_t* label_of, std::int32_t* labels, int threads = 1);

}  // namespace epcc
