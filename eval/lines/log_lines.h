// SPDX-License-Identifier: BSD-3-Clause
// The lines of all scans of a log.
#pragma once

#include <vector>

#include "datasets/files/laser_log.h"
#include "epcc_segmentation/laser_line_extractor.h"

namespace epcc {

struct LogLines {
  std::vector<LaserLines> scans;  ///< one for each record of the log
  double seconds = 0.0;           ///< of the extraction, all threads added up
};

/// Scans do not depend on each other: the result is the same for any number of threads. Throws std::runtime_error with
/// the scan's number if one cannot be used.
LogLines findLines(const LaserLog& log, const SensorModel& noise, const LaserLineParameters& parameters, int threads);

}  // namespace epcc
