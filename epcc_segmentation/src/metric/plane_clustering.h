// SPDX-License-Identifier: BSD-3-Clause
// Algorithm 2: one pass over the scan lines clusters their line segments into planes.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "epcc_segmentation/depth_frame.h"
#include "epcc_segmentation/parameters.h"
#include "epcc_segmentation/sensor_model.h"
#include "metric/clustered_line.h"
#include "metric/recursive_statistics.h"

namespace epcc {

/// Plane prototype: recursive statistics of segment endpoints (Eqs. 12, 25, 26), sigma_j^2 and unit normal.
struct PlanePrototype {
  RecursiveStatistics<3> statistics;
  double variance = 0.0;       ///< sigma_j^2 = smallest eigenvalue of Sigma_j
  double mean_distance = 0.0;  ///< mu_jd of Eq. 26, running mean of the endpoints' distances
  int distances = 0;
  int fitted = 0;  ///< samples at the last refit()
  int segments = 0;
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();

  double distance(const Eigen::Vector3d& p) const { return (p - statistics.mean).dot(normal); }
  /// Takes an endpoint, weighted by Eq. 26 in one of its forms with the distance to the prototype before the update.
  void add(const Eigen::Vector3d& endpoint, EndpointWeight form);
  /// Normal and sigma_j^2 from the covariance.
  void refit();
};

/// Algorithm 2 as an object that is fed the segments of one scan line at a time, in order.
class PlaneClustering {
 public:
  static constexpr int kUnlabelled = -1;
  static constexpr int kReleased = -2;

  PlaneClustering(const PaperParameters& parameters, const SensorModel& sensor) : sensor_(sensor) {
    configure(parameters, sensor);
  }
  void configure(const PaperParameters& parameters, const SensorModel& sensor);

  /// Forgets everything; `projection` is that of the lines to come.
  void begin(Projection projection);
  /// Clusters the segments of the next scan line.
  void addLine(const std::vector<ClusteredLine>& segments);
  /// Drops small planes. Afterwards labels() are final.
  void finish();

  /// Label of each segment fed so far, in order of feeding: index into planes() or kUnlabelled.
  const std::vector<int>& labels() const { return labels_; }
  const std::vector<PlanePrototype>& planes() const { return planes_; }

  // For a stream, whose lines and planes do not stay. A frame calls none of these.

  /// Labels of the segments of the line `back` lines before the last one, at most look_back; a later line may label
  /// those that are not yet.
  const int* labelsOfLine(std::size_t back) const { return labels_.data() + lines_[lines_.size() - 1 - back].begin; }
  /// The plane takes no more segments: those that it has become kReleased, and another plane gets its place.
  void release(int plane);
  /// Forgets, now and then, the lines that no coming one looks back to; labels() are those of the rest.
  void forgetOldLines();

 private:
  struct Segment {
    Eigen::Vector3d a, b;
    Eigen::Vector3d ray_a, ray_b;                 // endpoint / measured depth
    double sensor_variance_a, sensor_variance_b;  // sigma_z^2 at the endpoints
    double low, high;                             // along the scan line
    double variance;                              // sigma_seg^2
    double reach;                                 // d_1 + sigma_z, Eq. 27
  };
  struct Line {
    std::size_t begin, end;  // segments
  };

  Segment makeSegment(const ClusteredLine& line_segment) const;
  double cost(const PlanePrototype& plane, const Segment& segment, double limit) const;
  static bool isWithinReach(const Segment& segment, const Segment& neighbour);
  static bool isBeyondReach(const Segment& segment, const Segment& neighbour);
  int bestPlane(const Segment& segment, std::size_t line);
  std::size_t startPartner(const Segment& segment, std::size_t line) const;
  void addToPlane(int plane, const Segment& segment);
  void startPlane(std::size_t first, std::size_t second);
  int freePlace();

  PaperParameters parameters_;
  SensorModel sensor_;
  double with_sensor_ = 1.0;   // sigma_z^2 counts in Eq. 23
  double with_segment_ = 1.0;  // sigma_seg^2 does
  double smallest_cosine_ = 0.0;
  Projection projection_ = Projection::Perspective;
  std::vector<Segment> segments_;
  std::vector<int> labels_;
  std::vector<Line> lines_;
  std::vector<PlanePrototype> planes_;
  std::vector<int> free_planes_;              // released
  std::vector<const Segment*> last_refused_;  // of each plane, by Eq. 23
};

}  // namespace epcc
