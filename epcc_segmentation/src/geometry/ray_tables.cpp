// SPDX-License-Identifier: BSD-3-Clause
// Medians of x/z and y/z, or of elevation, and circular means of azimuth, in the rows and columns of the lattice.
#include "geometry/ray_tables.h"

#include <algorithm>
#include <cmath>

namespace epcc {

namespace {

constexpr double kFewestInFront = 0.6;  // of the points of a camera; what is behind it was not measured
constexpr double kQuantile = 0.8;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

double middle(std::vector<double>& values) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

double wrapped(double angle) {
  return std::remainder(angle, 2.0 * M_PI);
}

}  // namespace

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
  if (residuals_.empty()) return kNoRays;
  const auto at =
      residuals_.begin() + static_cast<std::ptrdiff_t>(kQuantile * static_cast<double>(residuals_.size() - 1));
  std::nth_element(residuals_.begin(), at, residuals_.end());
  return *at;
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
    const double median = middle(group_);
    table_[static_cast<std::size_t>(values[begin].group)] = median;
    sum += median;
    squares += median * median;
    count += 1.0;
    if (group_.size() > 1)
      for (const double value : group_) residuals_.push_back(std::abs(value - median));
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
  sortByGroup(across_, lattice.columns().size());
  return std::max(of_rows, tableResidual(across_, lattice.columns().size()));
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
  // The columns' azimuths go on from one to the next by less than half a turn.
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
  const double deviation = std::abs(span) / std::sqrt(12.0);
  return deviation > 0.0 ? quantile() / deviation : kNoRays;
}

}  // namespace epcc
