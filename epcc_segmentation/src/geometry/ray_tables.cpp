// SPDX-License-Identifier: BSD-3-Clause
// Medians of x/z and y/z, or of elevation, and circular means of azimuth, in the rows and columns of the lattice.
#include "geometry/ray_tables.h"

#include <algorithm>
#include <cmath>

#include "quantile.h"

namespace epcc {

namespace {

constexpr double kFewestInFront = 0.6;  // of the points of a camera; what is behind it was not measured
constexpr double kQuantile = 0.8;
// Of a coordinate with the places of the columns or rows: 1 of a pinhole camera and of a scanner, 0.9 of the widest
// lens that passes for a camera, 1/2 of two rows that stand beside each other as one.
constexpr double kLeastCorrelation = 0.75;
// What rings are ahead of each other, in parts of the columns' range: 0.3 of real scanners, 1 where every second row is
// the other half of the one above.
constexpr double kMostAhead = 0.7;
constexpr double kMostTurn = 2.5 * M_PI;  // of the columns of one cloud
constexpr double kRepeated = 0.15;        // of the mean step from ring to ring
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

double wrapped(double angle) {
  return std::remainder(angle, 2.0 * M_PI);
}

}  // namespace

bool goesOn(const std::vector<double>& values) {
  double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, yy = 0.0, xy = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (std::isnan(values[i])) continue;
    const double at = static_cast<double>(i), value = values[i];
    n += 1.0;
    x += at;
    y += value;
    xx += at * at;
    yy += value * value;
    xy += at * value;
  }
  const double of_places = n * xx - x * x, of_values = n * yy - y * y, of_both = n * xy - x * y;
  return of_both * of_both >= kLeastCorrelation * kLeastCorrelation * of_places * of_values;
}

void RayTables::MeanAngle::add(double angle) {
  x += std::cos(angle);
  y += std::sin(angle);
}

double RayTables::MeanAngle::angle() const {
  return x == 0.0 && y == 0.0 ? kNan : std::atan2(y, x);
}

double RayTables::residual(const PointLattice& lattice, const PoseHypothesis& pose) {
  return pose.is_scanner ? scannerResidual(lattice, pose) : cameraResidual(lattice, pose);
}

double RayTables::quantile() {
  return residuals_.empty() ? kNoRays : epcc::quantile(residuals_, kQuantile);
}

bool RayTables::repeatsRings() {
  group_.clear();
  for (const double elevation : ring_elevation_)
    if (!std::isnan(elevation)) group_.push_back(elevation);
  if (group_.size() < 3) return false;
  std::sort(group_.begin(), group_.end());
  residuals_.clear();  // to the nearest
  for (std::size_t i = 0; i < group_.size(); ++i)
    residuals_.push_back(
        std::min(i > 0 ? group_[i] - group_[i - 1] : M_PI, i + 1 < group_.size() ? group_[i + 1] - group_[i] : M_PI));
  const double step = (group_.back() - group_.front()) / static_cast<double>(group_.size() - 1);
  return median(residuals_) < kRepeated * step;
}

/// Brings values group by group: each to its place, as many as come before.
void RayTables::sortByGroup(std::vector<Value>& values, std::size_t groups) {
  starts_.assign(groups + 1, 0);
  for (const Value& v : values) ++starts_[static_cast<std::size_t>(v.group) + 1];
  for (std::size_t g = 0; g < groups; ++g) starts_[g + 1] += starts_[g];
  sorted_.resize(values.size());
  for (const Value& v : values) sorted_[starts_[static_cast<std::size_t>(v.group)]++] = v;
  values.swap(sorted_);
}

/// Values come group by group.
double RayTables::tableResidual(std::vector<Value>& values, std::size_t groups) {
  table_.assign(groups, kNan);
  residuals_.clear();
  double sum = 0.0, squares = 0.0, count = 0.0;
  for (std::size_t begin = 0, end = 0; begin < values.size(); begin = end) {
    group_.clear();
    for (; end < values.size() && values[end].group == values[begin].group; ++end) group_.push_back(values[end].value);
    const double middle = median(group_);
    table_[static_cast<std::size_t>(values[begin].group)] = middle;
    sum += middle;
    squares += middle * middle;
    count += 1.0;
    if (group_.size() > 1)
      for (const double value : group_) residuals_.push_back(std::abs(value - middle));
  }
  if (count < 2.0) return kNoRays;
  const double deviation = std::sqrt(std::max(0.0, squares / count - (sum / count) * (sum / count)));
  return deviation > 0.0 ? quantile() / deviation : kNoRays;
}

double RayTables::cameraResidual(const PointLattice& lattice, const PoseHypothesis& pose) {
  across_.clear();
  along_.clear();
  for (const PointLattice::Point& point : lattice.points()) {
    const Eigen::Vector3d s = pose.inSensor(point.p);
    if (!(s.z() > 0.0)) continue;
    across_.push_back({point.column, point.row, s.x() / s.z()});
    along_.push_back({point.row, point.column, s.y() / s.z()});
  }
  if (static_cast<double>(along_.size()) < kFewestInFront * static_cast<double>(lattice.points().size()))
    return kNoRays;
  const double of_rows = tableResidual(along_, lattice.rows().size());
  if (!(of_rows < 0.5)) return of_rows;
  if (!goesOn(table_)) return kNoRays;
  sortByGroup(across_, lattice.columns().size());
  const double of_columns = tableResidual(across_, lattice.columns().size());
  return goesOn(table_) ? std::max(of_rows, of_columns) : kNoRays;
}

double RayTables::scannerResidual(const PointLattice& lattice, const PoseHypothesis& pose) {
  across_.clear();  // azimuths, by column
  along_.clear();   // elevations, by ring
  for (const PointLattice::Point& point : lattice.points()) {
    const Eigen::Vector3d s = pose.inSensor(point.p);
    const int ring = pose.rings_are_columns ? point.column : point.row;
    const int column = pose.rings_are_columns ? point.row : point.column;
    across_.push_back({column, ring, std::atan2(s.y(), s.x())});
    along_.push_back({ring, column, std::atan2(s.z(), std::hypot(s.x(), s.y()))});
  }
  const std::size_t rings = pose.rings_are_columns ? lattice.columns().size() : lattice.rows().size();
  const std::size_t columns = pose.rings_are_columns ? lattice.rows().size() : lattice.columns().size();
  sortByGroup(along_, rings);
  const double of_rings = tableResidual(along_, rings);
  ring_elevation_ = table_;
  if (!(of_rings < 0.5)) return of_rings;
  return std::max(of_rings, azimuthResidual(columns, rings));
}

/// Of the columns without what the rings are ahead, or of the rings without what the columns have.
void RayTables::meanAzimuths(bool of_rings, std::vector<double>& table) {
  means_.assign(table.size(), MeanAngle());
  for (const Value& v : across_) {
    const double other = of_rings ? column_azimuth_[static_cast<std::size_t>(v.group)]
                                  : ring_azimuth_[static_cast<std::size_t>(v.other)];
    means_[static_cast<std::size_t>(of_rings ? v.other : v.group)].add(v.value - other);
  }
  for (std::size_t i = 0; i < table.size(); ++i) table[i] = means_[i].angle();
}

// azimuth = that of the column + that by which the ring is ahead: each in turn is the mean of what the other leaves.
double RayTables::azimuthResidual(std::size_t columns, std::size_t rings) {
  ring_azimuth_.assign(rings, 0.0);
  column_azimuth_.assign(columns, 0.0);
  meanAzimuths(false, column_azimuth_);
  for (int pass = 0; pass < 3; ++pass) {
    meanAzimuths(true, ring_azimuth_);
    meanAzimuths(false, column_azimuth_);
  }
  residuals_.clear();
  for (const Value& v : across_)
    residuals_.push_back(std::abs(wrapped(v.value - column_azimuth_[static_cast<std::size_t>(v.group)] -
                                          ring_azimuth_[static_cast<std::size_t>(v.other)])));
  const double span = std::abs(unwrapColumns());
  const double deviation = span / std::sqrt(12.0);
  return deviation > 0.0 && columnsGoOn(span) ? quantile() / deviation : kNoRays;
}

/// The columns' azimuths go on from one to the next by less than half a turn. Returns how far.
double RayTables::unwrapColumns() {
  double before = kNan, span = 0.0;
  for (double& azimuth : column_azimuth_) {
    if (std::isnan(azimuth)) continue;
    if (!std::isnan(before)) {
      const double step = wrapped(azimuth - before);
      span += step;
      azimuth = before + step;
    }
    before = azimuth;
  }
  return span;
}

bool RayTables::columnsGoOn(double span) const {
  double least = kNan, most = kNan;
  for (const double ahead : ring_azimuth_) {
    least = std::fmin(least, ahead);
    most = std::fmax(most, ahead);
  }
  return span <= kMostTurn && !(most - least > kMostAhead * span) && goesOn(column_azimuth_);
}

}  // namespace epcc
