// SPDX-License-Identifier: BSD-3-Clause
// A few hundred values in order.
#pragma once

#include "sensor/block_samples.h"

namespace epcc {

constexpr int kMaxOrdered = kMaxBlockPixels / 4;

/// Orders `count` values, at most kMaxOrdered; no NaN.
void orderValues(float* values, int count);

}  // namespace epcc
