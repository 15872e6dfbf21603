// SPDX-License-Identifier: BSD-3-Clause
// Which reader a log is for.
#include "datasets/files/laser_log.h"

#include <cmath>

#include "datasets/support/input_error.h"

namespace epcc {

Vector2 LaserPose::toWorld(const Vector2& point) const {
  const double c = std::cos(theta), s = std::sin(theta);
  return {x + c * point.x() - s * point.y(), y + s * point.x() + c * point.y()};
}

void LaserLog::addProblem(const std::string& problem) {
  if (problems.size() < kMaxProblems)
    problems.push_back(problem);
  else
    ++more_problems;
}

void checkLogSize(const std::string& path, long line, std::size_t scans, std::size_t beams) {
  if (scans <= kMaxLogScans && beams <= kMaxLogBeams) return;
  const std::string place = "line " + std::to_string(line);
  if (scans > kMaxLogScans)
    throw InputError(path, place, "more than " + std::to_string(kMaxLogScans) + " scans: split the log");
  throw InputError(path, place, "more than " + std::to_string(kMaxLogBeams) + " beams: split the log");
}

LaserLog readLaserLog(const std::string& path) {
  const std::uintmax_t size = inputFileSize(path);
  TextLines lines(path);
  std::string_view line;
  bool table = false;
  while (lines.next(line)) {
    if (line.find_first_not_of(" \t\r") == std::string_view::npos) continue;
    table = line.find("angle_min") != std::string_view::npos;
    break;
  }
  LaserLog log = table ? readScanTable(path) : readCarmenLog(path);
  if (log.problems.empty()) requireNotCutOff(path, size);  // nor before its reader opened it
  if (log.records.empty())
    throw log.problems.empty()
        ? InputError(path, "scans", "there are none; neither a CARMEN log with laser messages nor a table of scans")
        : InputError(path, "scans", "none can be used; " + log.problems.front().substr(path.size() + 2));
  return log;
}

}  // namespace epcc
