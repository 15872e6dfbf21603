// SPDX-License-Identifier: BSD-3-Clause
// The paper mode: Algorithm 1 on every scan line, Algorithm 2 over the lines in order, with its memory.
#pragma once

#include <cstdint>
#include <vector>

#include "epcc_segmentation/depth_frame.h"
#include "epcc_segmentation/line_segment.h"
#include "epcc_segmentation/parameters.h"
#include "epcc_segmentation/sensor_model.h"
#include "metric/clustered_line.h"
#include "metric/line_clustering.h"
#include "metric/ordered_turns.h"
#include "metric/plane_clustering.h"
#include "metric/scan_strips.h"
#include "metric/strip_lines.h"
#include "segment_fit.h"

namespace epcc {

/// Segments views whose scan lines are columns; a row scan passes the transposed view. Keeps its memory.
class MetricPipeline {
 public:
  MetricPipeline(const Parameters& parameters, const SensorModel& sensor);
  /// For the frames to come; the memory is kept.
  void configure(const Parameters& parameters, const SensorModel& sensor);

  /// Algorithm 1; with several threads also Algorithm 2, as far as it comes meanwhile.
  void clusterLines(const DepthFrame& view);
  /// Algorithm 2, what is left of it.
  void clusterPlanes();
  /// A pixel takes its segment's plane, planes numbered by size, largest first; those with too few pixels are dropped.
  /// Returns the number of planes.
  int labelPixels(const DepthFrame& view, std::vector<std::int32_t>& labels);
  /// All line segments with the labels that their pixels have in the end.
  void listSegments(const DepthFrame& view, const std::vector<std::int32_t>& labels, SegmentFitter& fitter,
                    std::vector<LineSegment>& segments) const;

  /// The segments of every scan line, and the number of each pixel's segment: rows of numberStride() pixels of the
  /// view.
  const std::vector<std::vector<ClusteredLine>>& lineSegments() const { return line_segments_; }
  const std::vector<std::int32_t>& numbers() const { return numbers_; }
  std::size_t numberStride() const { return strips_.paddedWidth(); }
  /// The depths that were clustered, rows of numberStride(); null where the columns are not those of a depth image.
  const float* depth() const { return strips_.depth(); }
  /// Number of the segment `index` of a scan line.
  std::int32_t numberOf(int column, std::size_t index) const {
    return 1 + static_cast<std::int32_t>(index * numberStride()) + column;
  }

 private:
  /// What a thread needs for its strips.
  struct StripMemory {
    std::vector<float> samples;
    StripLines lines;
  };
  void clusterStrip(const DepthFrame& view, int strip, StripMemory& memory);
  void clusterPlanesOf(int strip);
  int numberPlanes();
  template <typename Visit>
  void forEachSegment(const Visit& visit) const;

  Parameters parameters_;
  SensorModel sensor_;
  ClusteringRule rule_;
  ScanStrips strips_;
  std::vector<StripMemory> memory_;  // one a thread
  OrderedTurns order_of_strips_;
  int capacity_ = 0;  // segments a scan line can have
  std::vector<std::vector<ClusteredLine>> line_segments_;
  std::vector<std::int32_t> numbers_;
  PlaneClustering plane_clustering_;
  std::vector<long> points_;                  // of each plane
  std::vector<std::size_t> order_;            // the planes by size
  std::vector<std::int32_t> label_of_plane_;  // 0: dropped
  std::vector<std::int32_t> label_of_number_;
};

}  // namespace epcc
