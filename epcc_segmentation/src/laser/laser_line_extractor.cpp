// SPDX-License-Identifier: BSD-3-Clause
// Scan -> samples -> lines grown -> borders -> hidden parts joined -> result.
#include "epcc_segmentation/laser_line_extractor.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <optional>
#include <utility>

#include "laser/laser_line_borders.h"
#include "laser/laser_line_description.h"
#include "laser/laser_line_growing.h"
#include "laser/laser_line_joining.h"
#include "laser/laser_samples.h"

namespace epcc {
namespace {

std::string scanProblem(const LaserScan& scan) {
  if (!scan.angles.empty()) {
    if (scan.angles.size() != scan.ranges.size())
      return std::to_string(scan.ranges.size()) + " ranges and " + std::to_string(scan.angles.size()) + " angles";
    for (const double angle : scan.angles)
      if (!std::isfinite(angle)) return "an angle is not finite";
  } else if (!std::isfinite(scan.angle_min) || !std::isfinite(scan.angle_increment)) {
    return "the angles are not finite";
  } else if (scan.angle_increment == 0.0 && scan.ranges.size() > 1) {
    return "the angle increment is zero";
  }
  return {};
}

}  // namespace

std::string LaserLineParameters::validate() const {
  const auto outside = [](double value, double low, double high) { return !(value >= low && value <= high); };
  if (outside(k_max, 0.5, 10.0)) return "k_max: must be 0.5 to 10";
  if (outside(min_points, 5, 1000)) return "min_points: must be 5 to 1000";
  if (outside(max_gap, 0.0, 1000.0)) return "max_gap: must be 0 to 1000 m";
  if (outside(max_hidden, 0.0, 1000.0)) return "max_hidden: must be 0 to 1000 m";
  return {};
}

LaserLineExtractor::LaserLineExtractor(const SensorModel& noise, const LaserLineParameters& parameters)
    : noise_(noise), parameters_(parameters) {}

bool LaserLineExtractor::fail(Status status, std::string error) {
  status_ = status;
  error_ = std::move(error);
  return false;
}

bool LaserLineExtractor::extract(const LaserScan& scan, LaserLines& result) {
  result.lines.clear();
  result.labels.clear();
  try {
    status_ = Status::Ok;
    error_.clear();
    std::string problem = parameters_.validate();
    if (problem.empty()) problem = noise_.validate();
    if (!problem.empty()) return fail(Status::InvalidParameters, problem);
    if (scan.ranges.empty()) return fail(Status::EmptyCloud, "the scan has no beams");
    problem = scanProblem(scan);
    if (!problem.empty()) return fail(Status::SizeMismatch, problem);

    const bool circle = scan.isFullCircle();
    const std::vector<LaserSample> samples = readSamples(scan, noise_, circle);
    std::vector<GrownLaserLine> lines = growLaserLines(samples, parameters_);
    settleBorders(samples, noise_, parameters_, lines);
    if (parameters_.join_hidden) {
      joinHiddenLines(samples, scan, noise_, parameters_, circle, lines);
      adoptHiddenPieces(samples, scan, noise_, parameters_, circle, lines);
    }

    result.labels.assign(scan.ranges.size(), 0);
    std::sort(lines.begin(), lines.end(), [&](const GrownLaserLine& a, const GrownLaserLine& b) {
      return samples[a.members.front()].beam < samples[b.members.front()].beam;
    });
    std::vector<GrownLaserLine> described;
    for (GrownLaserLine& grown : lines) {
      const std::optional<LaserLine> line = describeLine(scan, samples, noise_, grown);
      if (!line) continue;
      result.lines.push_back(*line);
      for (const int i : grown.members)
        result.labels[static_cast<std::size_t>(samples[i].beam)] = static_cast<std::int32_t>(result.lines.size());
      described.push_back(std::move(grown));
    }
    placeCorners(scan, described, result);
    return true;
  } catch (const std::bad_alloc&) {
    result.lines.clear();
    result.labels.clear();
    return fail(Status::OutOfMemory, "out of memory");  // short enough to need none
  }
}

}  // namespace epcc
