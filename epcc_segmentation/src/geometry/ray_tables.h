// SPDX-License-Identifier: BSD-3-Clause
// How well a pose explains a cloud: how nearly the points of a column, and of a row, share a coordinate of their rays.
#pragma once

#include <limits>
#include <vector>

#include "geometry/point_lattice.h"

namespace epcc {

/// A pose that a cloud may have been seen from.
struct PoseHypothesis {
  bool is_scanner = false;
  bool rings_are_columns = false;  ///< of a scanner
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();

  Eigen::Vector3d inSensor(const Eigen::Vector3d& p) const { return axes.transpose() * (p - origin); }
};

/// No pose at all.
constexpr double kNoRays = std::numeric_limits<double>::infinity();

/// Values grow, or fall, with their places; NaN counts for nothing. Else the rows of a picture were cut or joined.
bool goesOn(const std::vector<double>& values);

/// Measures hypotheses on a lattice of points. Keeps its memory.
class RayTables {
 public:
  /// The 80 % quantile of what the points are off the coordinate of their column or row, in deviations of the
  /// coordinate over the cloud; the worse of both. A few points may be anything. Infinite if points lie behind a camera
  /// or the tables do not go on from column to column and row to row, as where the cloud's width is wrong.
  double residual(const PointLattice& lattice, const PoseHypothesis& pose);

  /// Of the scanner that was measured last: azimuth of each column of the lattice, as it goes on, and what a ring is
  /// ahead of it; elevation of each ring. NaN where the lattice has no point.
  const std::vector<double>& columnAzimuth() const { return column_azimuth_; }
  const std::vector<double>& ringAzimuth() const { return ring_azimuth_; }
  const std::vector<double>& ringElevation() const { return ring_elevation_; }
  /// Most of its rings have a twin at their elevation, which those of no scanner have.
  bool repeatsRings();

 private:
  /// A sum of unit vectors, whose direction is the mean of angles.
  struct MeanAngle {
    double x = 0.0, y = 0.0;
    void add(double angle);
    double angle() const;  ///< NaN of none
  };
  struct Value {
    int group, other;  // places in the lattice
    double value;
  };
  double cameraResidual(const PointLattice& lattice, const PoseHypothesis& pose);
  double scannerResidual(const PointLattice& lattice, const PoseHypothesis& pose);
  void sortByGroup(std::vector<Value>& values, std::size_t groups);
  double tableResidual(std::vector<Value>& values, std::size_t groups);
  double azimuthResidual(std::size_t columns, std::size_t rings);
  void meanAzimuths(bool of_rings, std::vector<double>& table);
  double unwrapColumns();
  bool columnsGoOn(double span) const;
  double quantile();

  std::vector<Value> across_, along_, sorted_;
  std::vector<std::size_t> starts_;  // of the groups
  std::vector<double> group_, table_, residuals_;
  std::vector<double> column_azimuth_, ring_azimuth_, ring_elevation_;
  std::vector<MeanAngle> means_;
};

}  // namespace epcc
