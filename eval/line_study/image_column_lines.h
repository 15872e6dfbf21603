// SPDX-License-Identifier: BSD-3-Clause
// The paper mode's line segments of a scan that is taken for a column of an image.
#pragma once

#include <vector>

#include "baselines/laser_line_methods.h"
#include "epcc_segmentation/sensor_model.h"

namespace epcc {

/// Algorithm 1 as it runs on image columns, whose samples all lie ahead of the sensor: of a scan these are the beams
/// within 89 degrees of angle 0. A beam is on a line if it lies between its first and last sample and is near it.
std::vector<MethodLine> imageColumnLines(const LaserScan& scan, const SensorModel& noise);

}  // namespace epcc
