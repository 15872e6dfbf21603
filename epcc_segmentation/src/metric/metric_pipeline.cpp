// SPDX-License-Identifier: BSD-3-Clause
// The paper's two algorithms in sequence.
#include "metric/metric_pipeline.h"

#include "metric/segment_record.h"
#include "parallel_for.h"

namespace epcc {

MetricPipeline::MetricPipeline(const Parameters& parameters, const SensorModel& sensor)
    : parameters_(parameters), sensor_(sensor), plane_clustering_(parameters.paper, sensor) {}

void MetricPipeline::configure(const Parameters& parameters, const SensorModel& sensor) {
  parameters_ = parameters;
  sensor_ = sensor;
  for (LineClustering& clustering : clusterings_) clustering.configure(parameters.paper);
  plane_clustering_.configure(parameters.paper, sensor);
}

void MetricPipeline::clusterLines(const DepthFrame& view) {
  scan_lines_.resize(static_cast<std::size_t>(parameters_.threads));
  clusterings_.resize(static_cast<std::size_t>(parameters_.threads), LineClustering(parameters_.paper));
  line_segments_.resize(static_cast<std::size_t>(view.width()));
  parallelFor(view.width(), parameters_.threads, [&](int thread, int begin, int end) {
    ScanLine& line = scan_lines_[static_cast<std::size_t>(thread)];
    for (int column = begin; column < end; ++column) {
      readScanLine(view, sensor_, column, line);
      clusterings_[static_cast<std::size_t>(thread)].cluster(line, line_segments_[static_cast<std::size_t>(column)]);
    }
  });
}

void MetricPipeline::clusterPlanes(const DepthFrame& view) {
  plane_clustering_.begin(view.projection());
  for (const auto& line : line_segments_) plane_clustering_.addLine(line.segments);
  plane_clustering_.finish();
}

int MetricPipeline::labelPixels(const DepthFrame& view, std::vector<std::int32_t>& labels) const {
  std::vector<long> points(plane_clustering_.planes().size(), 0);
  forEachLabelled([&](std::size_t plane, int, const ClusteredLines&, const ClusteredLine& segment) {
    points[plane] += segment.member_end - segment.member_begin;
  });
  std::vector<std::int32_t> label_of(points.size(), 0);
  std::int32_t count = 0;
  for (std::size_t plane = 0; plane < points.size(); ++plane)
    if (points[plane] > 0 && points[plane] >= parameters_.paper.min_points) label_of[plane] = ++count;
  forEachLabelled([&](std::size_t plane, int column, const ClusteredLines& line, const ClusteredLine& segment) {
    for (int i = segment.member_begin; i < segment.member_end; ++i)
      labels[view.index(line.members[static_cast<std::size_t>(i)], column)] = label_of[plane];
  });
  return count;
}

void MetricPipeline::listSegments(const DepthFrame& view, const std::vector<std::int32_t>& labels,
                                  std::vector<LineSegment>& segments) const {
  for (int column = 0; column < view.width(); ++column)
    for (const ClusteredLine& line : line_segments_[static_cast<std::size_t>(column)].segments) {
      segments.push_back(lineSegmentOf(view, column, line));
      segments.back().label = labels[view.index(line.first, column)];  // all of its pixels have it
    }
}

template <typename Visit>
void MetricPipeline::forEachLabelled(const Visit& visit) const {
  std::size_t next = 0;
  for (std::size_t column = 0; column < line_segments_.size(); ++column)
    for (const auto& segment : line_segments_[column].segments) {
      const int plane = plane_clustering_.labels()[next++];
      if (plane != PlaneClustering::kUnlabelled)
        visit(static_cast<std::size_t>(plane), static_cast<int>(column), line_segments_[column], segment);
    }
}

}  // namespace epcc
