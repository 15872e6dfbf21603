// SPDX-License-Identifier: BSD-3-Clause
// What holds for every log of laser scans.
#pragma once

#include <cmath>

#include "datasets/files/laser_log.h"
#include "tests/fuzz/require.h"

namespace epcc::fuzz {

inline void checkRecord(const LaserRecord& record) {
  const LaserScan& scan = record.scan;
  require(!scan.ranges.empty() && scan.ranges.size() <= kMaxScanBeams, "a scan has beams, and not too many");
  require(std::isfinite(scan.angle_min) && std::isfinite(scan.angle_increment), "angles are finite");
  require(scan.angle_increment != 0.0, "beams differ");
  require(scan.range_max > scan.range_min, "there are ranges that count");
  require(!record.timestamp || std::isfinite(*record.timestamp), "times are finite");
  if (record.pose)
    require(std::isfinite(record.pose->x) && std::isfinite(record.pose->y) && std::isfinite(record.pose->theta),
            "poses are finite");
  require(record.line > 0, "a scan knows its line");
}

inline void checkLog(const LaserLog& log) {
  for (const LaserRecord& record : log.records) checkRecord(record);
  for (const std::string& problem : log.problems) requireOneLine(problem);
  require(log.problems.size() <= LaserLog::kMaxProblems, "problems are counted");
}

}  // namespace epcc::fuzz
