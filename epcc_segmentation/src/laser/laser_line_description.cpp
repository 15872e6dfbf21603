// SPDX-License-Identifier: BSD-3-Clause
// What is told of a line: parameters, ends, and how sure they are.
#include "laser/laser_line_description.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "laser/laser_samples.h"
#include "symmetric_part.h"

namespace epcc {
namespace {

// Mean square, in steps from beam to beam, of where a surface ends behind its last point: anywhere in the next step,
// 1/3, and in one case of twenty, where that point was trimmed, anywhere in the one behind it, 7/3.
constexpr double kEndVariance = 0.43;
constexpr int kCornerBeams = 3;        // that may lie between two lines which share a corner
constexpr double kCornerSigmas = 3.0;  // from the end that the beams show

/// Position and covariance of an end: where `beam` meets the line, and along it up to where the next one would.
void setEnd(const RangeLine& line, const Eigen::Vector2d& beam, const Eigen::Vector2d& next, Vector2& point,
            Matrix2& covariance) {
  point = line.point(beam);
  covariance = line.rangeVariance(beam) * symmetricPart(beam * beam.transpose());
  if (!(line.range(next) > 0.0)) return;
  const Eigen::Vector2d step = line.point(next) - line.point(beam);
  covariance += kEndVariance * symmetricPart(step * step.transpose());
}

/// Of (alpha, rho), from that of q.
Matrix2 polarCovariance(const RangeLine& line) {
  const double square = line.q.squaredNorm(), rho = 1.0 / std::sqrt(square);
  Eigen::Matrix2d jacobian;
  jacobian << -line.q.y() / square, line.q.x() / square, -line.q.x() * rho * rho * rho, -line.q.y() * rho * rho * rho;
  return symmetricPart(jacobian * line.covariance * jacobian.transpose());
}

/// Factor of the covariance: the errors' own size where they are larger than the noise model by more than chance.
double covarianceScale(double chi_squared, double freedom) {
  return chi_squared > 1.0 + 3.0 * std::sqrt(2.0 / freedom) ? chi_squared : 1.0;
}

}  // namespace

std::optional<LaserLine> describeLine(const LaserScan& scan, const std::vector<LaserSample>& samples,
                                      const SensorModel& noise, GrownLaserLine& grown) {
  const int beams = static_cast<int>(scan.ranges.size());
  RangeLine& line = grown.line;
  const double freedom = static_cast<double>(grown.members.size()) - 2.0;
  LaserLine result;
  result.first = samples[grown.members.front()].beam;
  result.last = samples[grown.members.back()].beam;
  result.points = static_cast<int>(grown.members.size());
  const double squared_errors = fitRangeLine(samples, grown.members, noise, line);
  if (!(squared_errors >= 0.0 && freedom > 0.0)) return std::nullopt;
  result.chi_squared = squared_errors / freedom;
  result.alpha = std::atan2(line.q.y(), line.q.x());
  result.rho = 1.0 / line.q.norm();
  line.covariance *= covarianceScale(result.chi_squared, freedom);
  result.covariance = polarCovariance(line);
  for (const int i : grown.members) {
    const double distance = line.q.normalized().dot(samples[i].point()) - result.rho;
    result.variance += distance * distance / freedom;
  }
  const auto direction = [&](int beam) { return beamDirection(scan, beam); };
  // At the edge of the scan there is no next beam: as far on as the last one is behind.
  const int before = result.first > 0 ? result.first - 1 : std::min(1, beams - 1);
  const int after = result.last + 1 < beams ? result.last + 1 : std::max(0, beams - 2);
  setEnd(line, direction(result.first), direction(before), result.start, result.start_covariance);
  setEnd(line, direction(result.last), direction(after), result.end, result.end_covariance);
  const bool is_line = result.start.allFinite() && result.end.allFinite() && result.covariance.allFinite() &&
                       result.start_covariance.allFinite() && result.end_covariance.allFinite() &&
                       std::isfinite(result.variance) && std::isfinite(result.rho);
  return is_line ? std::optional<LaserLine>(result) : std::nullopt;
}

namespace {

/// Where two lines cross, and the covariance of that; false where they are parallel.
bool crossing(const RangeLine& a, const RangeLine& b, Eigen::Vector2d& point, Eigen::Matrix2d& covariance) {
  Eigen::Matrix2d rows;
  rows << a.q.transpose(), b.q.transpose();
  const double determinant = rows.determinant();
  if (std::abs(determinant) < 1e-6 * a.q.norm() * b.q.norm()) return false;
  const Eigen::Matrix2d inverse = rows.inverse();
  point = inverse * Eigen::Vector2d::Ones();
  // rows * point = 1: an error dq of a row moves the point by -inverse * (dq . point).
  const Eigen::Vector2d variances(point.dot(a.covariance * point), point.dot(b.covariance * point));
  covariance = symmetricPart(inverse * variances.asDiagonal() * inverse.transpose());
  return true;
}

/// Whether the end that the beams show can be at a point.
bool mayEndAt(const Vector2& end, const Matrix2& end_covariance, const Eigen::Vector2d& point,
              const Eigen::Matrix2d& covariance) {
  const Eigen::Vector2d difference = end - point;
  const Eigen::Matrix2d both = end_covariance + covariance;
  const double determinant = both.determinant();
  if (!(determinant > 0.0)) return false;
  return difference.dot(both.inverse() * difference) <= 2.0 * kCornerSigmas * kCornerSigmas &&
         covariance.trace() < end_covariance.trace();
}

}  // namespace

void placeCorners(const LaserScan& scan, const std::vector<GrownLaserLine>& grown, LaserLines& result) {
  const int beams = static_cast<int>(scan.ranges.size());
  const bool circle = scan.isFullCircle();
  for (std::size_t k = 0; k < result.lines.size(); ++k) {
    LaserLine& line = result.lines[k];
    for (int step = 1; step <= kCornerBeams; ++step) {
      const int beam = line.last + step;
      if (beam >= beams && !circle) break;
      const std::int32_t label = result.labels[static_cast<std::size_t>(beam % beams)];
      if (label == 0) continue;
      LaserLine& next = result.lines[static_cast<std::size_t>(label - 1)];
      if (&next == &line || next.first != beam % beams) break;
      Eigen::Vector2d point;
      Eigen::Matrix2d covariance;
      if (!crossing(grown[k].line, grown[static_cast<std::size_t>(label - 1)].line, point, covariance)) break;
      if (!mayEndAt(line.end, line.end_covariance, point, covariance) ||
          !mayEndAt(next.start, next.start_covariance, point, covariance))
        break;
      line.end = next.start = point;
      line.end_covariance = next.start_covariance = covariance;
      line.ends_in_corner = next.starts_in_corner = true;
      break;
    }
  }
}

}  // namespace epcc
