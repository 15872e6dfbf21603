// SPDX-License-Identifier: BSD-3-Clause
// Scan -> samples -> lines grown -> borders -> hidden parts joined -> result.
#include "epcc_segmentation/laser_line_extractor.h"

#include <algorithm>
#include <cmath>
#include <new>

#include "laser/laser_line_borders.h"
#include "laser/laser_line_growing.h"
#include "laser/laser_line_joining.h"
#include "laser/laser_samples.h"

namespace epcc {
namespace {

/// Position and covariance of an end: where `beam` meets the line, and along it up to where the next one would.
void setEnd(const RangeLine& line, const Eigen::Vector2d& beam, const Eigen::Vector2d& next, double scale,
            Vector2& point, Matrix2& covariance) {
  point = line.point(beam);
  covariance = scale * line.rangeVariance(beam) * beam * beam.transpose();
  if (!(line.range(next) > 0.0)) return;
  const Eigen::Vector2d step = line.point(next) - line.point(beam);
  covariance += step * step.transpose() / 3.0;  // mean square of what is evenly distributed from 0 to step
}

/// Of (alpha, rho), from that of q.
Matrix2 polarCovariance(const RangeLine& line) {
  const double square = line.q.squaredNorm(), rho = 1.0 / std::sqrt(square);
  Eigen::Matrix2d jacobian;
  jacobian << -line.q.y() / square, line.q.x() / square, -line.q.x() * rho * rho * rho, -line.q.y() * rho * rho * rho;
  return jacobian * line.covariance * jacobian.transpose();
}

/// Factor of the covariance: the errors' own size where they are larger than the noise model by more than chance.
double covarianceScale(double chi_squared, double freedom) {
  return chi_squared > 1.0 + 3.0 * std::sqrt(2.0 / freedom) ? chi_squared : 1.0;
}

LaserLine describe(const LaserScan& scan, const std::vector<LaserSample>& samples, const SensorModel& noise,
                   const GrownLaserLine& grown) {
  const int beams = static_cast<int>(scan.ranges.size());
  RangeLine line = grown.line;
  const double freedom = static_cast<double>(grown.members.size()) - 2.0;
  LaserLine result;
  result.first = samples[grown.members.front()].beam;
  result.last = samples[grown.members.back()].beam;
  result.points = static_cast<int>(grown.members.size());
  result.chi_squared = fitRangeLine(samples, grown.members, noise, line) / freedom;
  result.alpha = std::atan2(line.q.y(), line.q.x());
  result.rho = 1.0 / line.q.norm();
  const double scale = covarianceScale(result.chi_squared, freedom);
  result.covariance = scale * polarCovariance(line);
  for (const int i : grown.members) {
    const double distance = line.q.normalized().dot(samples[i].point()) - result.rho;
    result.variance += distance * distance / freedom;
  }
  const auto direction = [&](int beam) { return beamDirection(scan, beam); };
  // At the edge of the scan there is no next beam: as far on as the last one is behind.
  const int before = result.first > 0 ? result.first - 1 : std::min(1, beams - 1);
  const int after = result.last + 1 < beams ? result.last + 1 : std::max(0, beams - 2);
  setEnd(line, direction(result.first), direction(before), scale, result.start, result.start_covariance);
  setEnd(line, direction(result.last), direction(after), scale, result.end, result.end_covariance);
  return result;
}

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
    if (parameters_.join_hidden) joinHiddenLines(samples, scan, noise_, parameters_, circle, lines);

    result.labels.assign(scan.ranges.size(), 0);
    std::sort(lines.begin(), lines.end(), [&](const GrownLaserLine& a, const GrownLaserLine& b) {
      return samples[a.members.front()].beam < samples[b.members.front()].beam;
    });
    for (const GrownLaserLine& grown : lines) {
      result.lines.push_back(describe(scan, samples, noise_, grown));
      for (const int i : grown.members)
        result.labels[static_cast<std::size_t>(samples[i].beam)] = static_cast<std::int32_t>(result.lines.size());
    }
    return true;
  } catch (const std::bad_alloc&) {
    result.lines.clear();
    result.labels.clear();
    return fail(Status::OutOfMemory, {});
  }
}

}  // namespace epcc
