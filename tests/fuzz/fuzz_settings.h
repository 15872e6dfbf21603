// SPDX-License-Identifier: BSD-3-Clause
// Parameters and sensor models made of any bytes, most of them usable.
#pragma once

#include <optional>

#include "epcc_segmentation/parameters.h"
#include "epcc_segmentation/sensor_model.h"
#include "tests/fuzz/fuzz_input.h"

namespace epcc::fuzz {

/// Of either mode, with some fields changed, to their limits and beyond.
Parameters takeParameters(FuzzInput& input);

/// None (it is measured), a preset, or one of any numbers.
std::optional<SensorModel> takeSensor(FuzzInput& input);

}  // namespace epcc::fuzz
