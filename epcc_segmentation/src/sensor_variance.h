// SPDX-License-Identifier: BSD-3-Clause
// sigma_z^2 in single precision, both forms of the sensor model without a branch.
#pragma once

#include "epcc_segmentation/sensor_model.h"

namespace epcc {

/// max(0, (k0 z + k1) z + k2)^2 + floor, within [smallest, largest].
struct SensorVariance {
  static constexpr float kSmallest = 1e-12f;  // of SensorModel
  static constexpr float kLargest = 1e8f;     // what exceeds it says nothing at any distance

  SensorVariance() = default;
  explicit SensorVariance(const SensorModel& sensor) : smallest(kSmallest), largest(kLargest) {
    const auto k = sensor.coefficients();
    if (sensor.isPolynomial()) {
      k0 = static_cast<float>(k[0]);
      k1 = static_cast<float>(k[1]);
      k2 = static_cast<float>(k[2]);
    } else {
      k0 = static_cast<float>(k[1]);
      floor = static_cast<float>(k[0] * k[0]);
    }
  }
  float k0 = 0.0f, k1 = 0.0f, k2 = 0.0f, floor = 0.0f, smallest = 0.0f, largest = 0.0f;
};

}  // namespace epcc
