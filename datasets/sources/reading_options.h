// SPDX-License-Identifier: BSD-3-Clause
// What a person knows of the numbers in a file, and what its reader does not.
#pragma once

#include <limits>
#include <optional>

#include "datasets/files/labelled_frame.h"

namespace epcc {

/// Said of depth images and clouds.
struct ReadingOptions {
  CloudOptions::Sensor sensor = CloudOptions::Sensor::Any;
  std::optional<double> unit;     ///< metres per unit of a cloud's coordinates or a depth image's numbers
  std::optional<double> invalid;  ///< a number that stands for nothing measured: all coordinates of a point, or a depth
  double min_depth = 0.0;         ///< metres
  double max_depth = std::numeric_limits<double>::infinity();
  bool is_distance = false;  ///< depth images hold lengths of rays

  bool areDefault() const;
};

/// Takes a frame that was read with nothing known as the options say.
void readAs(LabelledFrame& frame, const ReadingOptions& options);

}  // namespace epcc
