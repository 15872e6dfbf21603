// SPDX-License-Identifier: BSD-3-Clause
// Logs of laser range finders: scans with their time and place.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "datasets/files/text_lines.h"
#include "epcc_segmentation/laser_scan.h"

namespace epcc {

/// Beams of a scan, and beams and scans of a log, that are read at most.
constexpr std::size_t kMaxScanBeams = 1000 * 1000;
constexpr std::size_t kMaxLogBeams = 200 * 1000 * 1000;
constexpr std::size_t kMaxLogScans = 10 * 1000 * 1000;

/// InputError, at a line of a log, if it has more than these so far: a packed file of a few megabytes may.
void checkLogSize(const std::string& path, long line, std::size_t scans, std::size_t beams);

/// Place and heading in a plane.
struct LaserPose {
  double x = 0.0, y = 0.0;  ///< metres
  double theta = 0.0;       ///< rad

  /// A point of the sensor's frame in the frame of the pose.
  Vector2 toWorld(const Vector2& point) const;
};

struct LaserRecord {
  LaserScan scan;
  std::optional<double> timestamp;  ///< seconds, as in the log
  std::optional<LaserPose> pose;    ///< of the sensor in the odometry's frame
  long line = 0;                    ///< of the file, from 1
};

struct LaserLog {
  std::vector<LaserRecord> records;
  /// What could not be used, each "FILE: line N: what"; at most kMaxProblems, the rest is counted.
  std::vector<std::string> problems;
  std::size_t more_problems = 0;
  static constexpr std::size_t kMaxProblems = 10;

  void addProblem(const std::string& problem);
};

/// Reads a log of CARMEN, or a table of scans, packed by gzip or not; the first line tells which. What is damaged is
/// left out and named in `problems`, also what follows where a packed file breaks off. InputError if the file cannot be
/// read at all or has no scan. The formats are explained in docs/reference/formats.md.
LaserLog readLaserLog(const std::string& path);

/// Of CARMEN: ROBOTLASER1, else FLASER, else RAWLASER1 messages; other messages are skipped. Ranges that are not below
/// the maximum range of the message are no returns; FLASER messages name none: there it is the largest range of the
/// log if at least ten beams have it, as a sensor's own "nothing" has.
LaserLog readCarmenLog(const std::string& path);

/// Of a table with a heading, one scan a line, as `rostopic echo -p` prints sensor_msgs/LaserScan.
LaserLog readScanTable(const std::string& path);

}  // namespace epcc
