// SPDX-License-Identifier: BSD-3-Clause
// Overlaps of beams, and errors of the lines that belong to a face.
#include "eval/line_study/line_scores.h"

#include <Eigen/LU>
#include <cmath>

namespace epcc {
namespace {

double squaredBy(const Eigen::Vector2d& error, const Eigen::Matrix2d& covariance) {
  return error.dot(covariance.inverse() * error);
}

void addErrors(const SeenFace& face, const ScoredLine& found, LineScores& scores) {
  const double alpha_error = std::remainder(found.alpha - face.alpha, 2.0 * std::acos(-1.0));
  const Vector2 middle = 0.5 * (face.start + face.end);
  scores.angle_errors.push_back(std::abs(alpha_error));
  scores.distance_errors.push_back(
      std::abs(std::cos(found.alpha) * middle.x() + std::sin(found.alpha) * middle.y() - found.rho));
  if (!found.line) return;
  const LaserLine& line = *found.line;
  scores.line_nees.push_back(squaredBy({alpha_error, found.rho - face.rho}, line.covariance));
  constexpr double kClear = 0.05;  // rad
  if (line.covariance(0, 0) < kClear * kClear) scores.clear_line_nees.push_back(scores.line_nees.back());
  const Eigen::Vector2d start = line.start - face.start, end = line.end - face.end;
  scores.end_errors.push_back(start.norm());
  scores.end_errors.push_back(end.norm());
  scores.end_nees.push_back(squaredBy(start, line.start_covariance));
  scores.end_nees.push_back(squaredBy(end, line.end_covariance));
}

void append(std::vector<double>& to, const std::vector<double>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

}  // namespace

LineScores& LineScores::operator+=(const LineScores& other) {
  faces += other.faces;
  lines += other.lines;
  regions += other.regions;
  append(angle_errors, other.angle_errors);
  append(distance_errors, other.distance_errors);
  append(line_nees, other.line_nees);
  append(clear_line_nees, other.clear_line_nees);
  append(end_errors, other.end_errors);
  append(end_nees, other.end_nees);
  seconds += other.seconds;
  scans += other.scans;
  return *this;
}

LineScores scoreLines(const FloorScan& truth, const std::vector<std::int32_t>& labels,
                      const std::vector<ScoredLine>& lines) {
  LineScores scores;
  scores.scans = 1;
  scores.lines = static_cast<long>(lines.size());
  std::vector<std::int32_t> asked = truth.labels;
  for (std::int32_t& label : asked)
    if (label > 0 && truth.faces[static_cast<std::size_t>(label - 1)].beams.size() < kFewestFaceBeams)
      label = kIgnoreLabel;
  const OverlapTable table(labels, asked, {});
  scores.faces = static_cast<long>(table.surfaceCount());
  scores.regions = segcompMeasures(table);
  for (std::size_t c = 1; c <= table.clusterCount(); ++c)
    for (std::size_t g = 1; g <= table.surfaceCount(); ++g) {
      const long both = table.overlap(c, g);
      if (2 * both <= table.clusterSize(c) || 2 * both <= table.surfaceSize(g)) continue;
      addErrors(truth.faces[static_cast<std::size_t>(table.surfaceIds()[g] - 1)],
                lines[static_cast<std::size_t>(table.clusterIds()[c] - 1)], scores);
    }
  return scores;
}

}  // namespace epcc
