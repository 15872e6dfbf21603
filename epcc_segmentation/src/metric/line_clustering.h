// SPDX-License-Identifier: BSD-3-Clause
// Algorithm 1: one pass over the samples of a scan line gives line segments.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "epcc_segmentation/parameters.h"
#include "metric/recursive_statistics.h"
#include "metric/scan_line.h"

namespace epcc {

/// Linear prototype: recursive statistics, residual variance (Eq. 11) and unit normal.
struct LinePrototype {
  RecursiveStatistics<2> statistics;
  double variance = 0.0;
  Eigen::Vector2d normal = Eigen::Vector2d::UnitX();

  /// Signed orthogonal distance (Eq. 19 without its absolute value).
  double distance(const Eigen::Vector2d& t) const { return (t - statistics.mean).dot(normal); }
  /// Foot of the perpendicular from a point (Eq. 21).
  Eigen::Vector2d project(const Eigen::Vector2d& t) const { return t - distance(t) * normal; }
  /// Takes a sample into mean, covariance and normal.
  void fit(const Eigen::Vector2d& t);
  /// The same, and Eq. 11 with the distance to the prototype before the update.
  void update(const Eigen::Vector2d& t);
  /// Residual variance := smallest eigenvalue of the covariance.
  void resetVariance() { variance = varianceAlong(statistics.covariance, normal); }
};

/// A line segment of one scan line.
struct ClusteredLine {
  int first = 0;  ///< pixel position of the first member along the scan line
  int last = 0;   ///< pixel position of the last member
  int member_begin = 0;
  int member_end = 0;  ///< members are ClusteredLines::members[member_begin .. member_end)
  LinePrototype prototype;
  /// Projections of the first and last member on the prototype (Eq. 21, signed), in the scan line's plane, metres.
  Eigen::Vector2d start = Eigen::Vector2d::Zero();
  Eigen::Vector2d end = Eigen::Vector2d::Zero();
  /// The same in the scan frame; set by cluster(), which knows the plane.
  Eigen::Vector3d a = Eigen::Vector3d::Zero();
  Eigen::Vector3d b = Eigen::Vector3d::Zero();
};

/// The segments of one scan line and their member pixels (positions along the line).
struct ClusteredLines {
  std::vector<ClusteredLine> segments;
  std::vector<int> members;
  void clear() {
    segments.clear();
    members.clear();
  }
};

/// Algorithm 1 as an object that is fed samples in order; its memory is reused from line to line.
class LineClustering {
 public:
  explicit LineClustering(const PaperParameters& parameters) { configure(parameters); }
  void configure(const PaperParameters& parameters) {
    k_max_ = parameters.line_k_max;
    parameters_ = parameters.expert.lines;
  }

  /// Clusters a whole scan line; `result` is cleared first.
  void cluster(const ScanLine& line, ClusteredLines& result);

  /// The same in steps, for streams: begin, add each sample, finish. `result` grows at each finished segment.
  void begin(ClusteredLines& result);
  void add(const ScanSample& sample);
  void finish();

 private:
  bool accepts(const LinePrototype& prototype, const ScanSample& sample) const;
  bool findNewSegment();
  void startSegment(std::size_t start, const LinePrototype& candidate);
  void takeMember(const ScanSample& sample);
  void emitSegment();

  double k_max_ = 0.0;
  PaperParameters::Lines parameters_;
  ClusteredLines* result_ = nullptr;
  bool has_active_ = false;
  LinePrototype active_;
  int member_begin_ = 0;
  Eigen::Vector2d first_sample_ = Eigen::Vector2d::Zero();
  Eigen::Vector2d last_sample_ = Eigen::Vector2d::Zero();
  std::vector<ScanSample> buffer_;
  std::vector<std::size_t> consistent_;
};

}  // namespace epcc
