// SPDX-License-Identifier: BSD-3-Clause
// What Algorithm 1 makes of a frame's scan lines.
#pragma once

#include <string>

#include "datasets/files/labelled_frame.h"
#include "epcc_segmentation/parameters.h"

namespace epcc {

struct LineStatistics {
  double segments_per_line = 0.0;  ///< over the scan lines that have a measurement
  double pixel_share = 0.0;        ///< share of the measured pixels that belong to a segment
};

/// Segments the frame with parameters of the paper mode. `sensor` as frameSensor() takes it. Throws std::runtime_error
/// if that fails.
LineStatistics lineStatistics(const LabelledFrame& frame, const Parameters& parameters, const std::string& sensor);

}  // namespace epcc
