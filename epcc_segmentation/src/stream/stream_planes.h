// SPDX-License-Identifier: BSD-3-Clause
// Algorithm 2 on a stream: planes while they grow, and lines until it is certain what their labels are.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "epcc_segmentation/scan_line_stream.h"
#include "metric/plane_clustering.h"
#include "stream/pending_lines.h"

namespace epcc {

/// Is fed one scan line at a time, hands out lines in order and planes behind their last line. Keeps its memory.
class StreamPlanes {
 public:
  std::function<void(const StreamPlane&)> on_plane;
  std::function<void(const LabelledLine&)> on_line;

  StreamPlanes() : clustering_(PaperParameters(), SensorModel::axial(1.0, 0.0)) {}
  /// `axes`: from the frame of the segments' moments to the sensor's. Forgets everything.
  void begin(const PaperParameters& parameters, const SensorModel& sensor, Projection projection,
             std::int64_t longest_plane, const Eigen::Matrix3d& axes);

  /// The next line, to be filled but for its serial and its segments' planes; then addLine().
  PendingLine& nextLine() { return lines_.push(); }
  /// Its segments, as many as it has.
  void addLine(const std::vector<ClusteredLine>& segments);
  /// So many lines are missing.
  void skipLines(std::int64_t count);
  /// Hands out everything. The next line begins anew.
  void finish();
  void listOpen(std::vector<StreamPlane>& planes) const;

 private:
  static constexpr std::int64_t kUndecided = 0;
  static constexpr std::int64_t kDropped = -1;

  struct GrowingPlane {
    int place = 0;                 // in the clustering
    std::int64_t id = kUndecided;  // or kDropped, or that of a plane that is large enough
    PointMoments moments;
    std::int64_t points = 0;
    std::int64_t segments = 0;
    std::int64_t first_line = 0, last_line = 0;  // indices
    std::int64_t last_serial = 0;
    bool is_cut = false;
  };

  void clusterLine(const std::vector<ClusteredLine>& segments);
  void labelSegments();
  int planeAt(int place, const PendingLine& line);
  void addSegment(const PendingLine& line, int plane, const PendingSegment& segment);
  void closePlanes();
  void closePlane(int plane);
  bool isDecided(const PendingLine& line) const;
  void handOutLines();
  void handOut(const PendingLine& line);
  void handOutPlanes();
  StreamPlane describe(const GrowingPlane& plane) const;

  PaperParameters parameters_;
  Projection projection_ = Projection::Perspective;
  std::int64_t longest_plane_ = 0;
  double pixels_per_sample_ = 1.0;
  Eigen::Matrix3d axes_ = Eigen::Matrix3d::Identity();
  PlaneClustering clustering_;
  std::int64_t serial_ = 0;  // of the last line that was clustered
  std::int64_t ids_ = 0;
  RecyclingQueue<PendingLine> lines_;
  std::vector<GrowingPlane> planes_;
  std::vector<int> free_;      // in planes_
  std::vector<int> open_;      // in planes_
  std::vector<int> closed_;    // in planes_, until their lines are handed out
  std::vector<int> at_place_;  // of each place in the clustering, in planes_
  std::vector<LabelRun> runs_;
};

}  // namespace epcc
