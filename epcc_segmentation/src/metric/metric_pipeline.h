// SPDX-License-Identifier: BSD-3-Clause
// The paper mode: Algorithm 1 on every scan line, Algorithm 2 over the lines in order, with its memory.
#pragma once

#include <vector>

#include "epcc_segmentation/depth_frame.h"
#include "epcc_segmentation/line_segment.h"
#include "epcc_segmentation/parameters.h"
#include "epcc_segmentation/sensor_model.h"
#include "metric/line_clustering.h"
#include "metric/plane_clustering.h"
#include "metric/scan_line.h"

namespace epcc {

/// Segments views whose scan lines are columns; a row scan passes the transposed view. Keeps its memory.
class MetricPipeline {
 public:
  MetricPipeline(const Parameters& parameters, const SensorModel& sensor);
  /// For the frames to come; the memory is kept.
  void configure(const Parameters& parameters, const SensorModel& sensor);

  void clusterLines(const DepthFrame& view);   ///< Algorithm 1
  void clusterPlanes(const DepthFrame& view);  ///< Algorithm 2
  /// A pixel takes its segment's plane; planes with too few pixels are dropped. Returns the number of planes.
  int labelPixels(const DepthFrame& view, std::vector<std::int32_t>& labels) const;
  /// All line segments with the labels that their pixels have in the end.
  void listSegments(const DepthFrame& view, const std::vector<std::int32_t>& labels,
                    std::vector<LineSegment>& segments) const;

 private:
  template <typename Visit>
  void forEachLabelled(const Visit& visit) const;

  Parameters parameters_;
  SensorModel sensor_;
  std::vector<ScanLine> scan_lines_;           // one a thread
  std::vector<LineClustering> clusterings_;    // one a thread
  std::vector<ClusteredLines> line_segments_;  // one a scan line
  PlaneClustering plane_clustering_;
};

}  // namespace epcc
