// SPDX-License-Identifier: BSD-3-Clause
// Poses that a cloud may have been seen from, each measured and the best one kept.
#pragma once

#include <string>
#include <vector>

#include "geometry/point_lattice.h"
#include "geometry/ray_tables.h"

namespace epcc {

/// Residual of a pose that needs no search, in deviations of all rays: 0.01 is 0.3 % of the image's side.
constexpr double kClearResidual = 0.003;
/// With more there are no rays: wide lenses that were not rectified and scans sorted into bins of angle have half of
/// it, what is no scan three times as much.
constexpr double kMaxResidual = 0.12;
/// Rows and columns of the lattice: a few hundred points tell a camera.
constexpr int kFewLines = 32;

struct Choice {
  PoseHypothesis pose;
  double residual = kNoRays;
  bool is_plain = false;  // a frame that DepthFrame knows
  Projection projection = Projection::Perspective;
};

/// A frame that DepthFrame knows.
Choice plainChoice(Projection projection);

/// The points of a cloud that poses are measured on, and the hypotheses. Each takes the place of `best` if it explains
/// the points so much better that it is not for its freedom. Keeps its memory.
struct HypothesisSearch {
  PointLattice lattice;
  RayTables tables;
  std::vector<Vector3f> other_markers;

  /// There are enough points, rows and columns to tell a camera from a scanner.
  bool tellsGeometry() const;
  /// Of the lattice, before any hypothesis.
  void measureSize();
  void consider(Choice choice, const CloudOptions& options, Choice& best);
  /// The axes of a frame in any order.
  void considerAxes(const SensorPose& from, const CloudOptions& options, Choice& best);
  /// Any pose.
  void considerSearch(const CloudOptions& options, Choice& best);
  /// Several columns (or rows) of the cloud are one ring: the rows of a picture stand beside each other.
  bool repeatsRings(const CloudView& cloud, const CloudOptions& options, const PoseHypothesis& pose);
  /// Which other width would make the points those of a camera or scanner, in words; empty if none does.
  std::string wrongSize(const CloudView& cloud, const CloudOptions& options);

 private:
  void considerCameras(const CloudOptions& options, Choice& best);
  void considerScanners(const CloudOptions& options, Choice& best);

  Eigen::Vector3d middle_ = Eigen::Vector3d::Zero();  // of the lattice's points
  double size_ = 0.0;                                 // their mean distance from it
  PointLattice all_rings_;
};

}  // namespace epcc
