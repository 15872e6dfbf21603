// SPDX-License-Identifier: BSD-3-Clause
// How functions take a sensor: an epcc.SensorModel, a text as of --noise, or None.
#pragma once

#include <pybind11/pybind11.h>

#include <optional>

#include "epcc_segmentation/sensor_model.h"

namespace epcc::python {

/// Nothing for None and "auto": the sensor is measured. Throws epcc.InputError for a text that names no sensor and
/// TypeError for what is neither.
std::optional<SensorModel> sensorOf(const pybind11::handle& sensor);

}  // namespace epcc::python
