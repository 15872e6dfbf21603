// SPDX-License-Identifier: BSD-3-Clause
// The pipeline of Figure 2: scan lines -> line segments -> planes -> labels.
#include "epcc_segmentation/plane_extractor.h"

#include <chrono>
#include <vector>

#include "metric/line_clustering.h"
#include "metric/plane_clustering.h"
#include "parallel_for.h"
#include "plane_fit.h"
#include "scan_line.h"

namespace epcc {

namespace {

double secondsSince(std::chrono::steady_clock::time_point& start) {
  const auto now = std::chrono::steady_clock::now();
  const double seconds = std::chrono::duration<double>(now - start).count();
  start = now;
  return seconds;
}

}  // namespace

/// Memory kept from frame to frame.
struct PlaneExtractor::Workspace {
  std::vector<ScanLine> scan_lines;         // one a thread
  std::vector<LineClustering> clusterings;  // one a thread
  std::vector<LineSegments> line_segments;  // one a scan line

  /// Algorithm 1 on every scan line.
  void clusterLines(const DepthFrame& view, const SensorModel& sensor, const Parameters& parameters) {
    scan_lines.resize(static_cast<std::size_t>(parameters.threads));
    clusterings.resize(static_cast<std::size_t>(parameters.threads), LineClustering(parameters.line));
    line_segments.resize(static_cast<std::size_t>(view.width()));
    parallelFor(view.width(), parameters.threads, [&](int thread, int begin, int end) {
      ScanLine& line = scan_lines[static_cast<std::size_t>(thread)];
      for (int column = begin; column < end; ++column) {
        readScanLine(view, sensor, column, line);
        clusterings[static_cast<std::size_t>(thread)].cluster(line, line_segments[static_cast<std::size_t>(column)]);
      }
    });
  }

  /// Algorithm 2 over the scan lines in order.
  void clusterPlanes(PlaneClustering& clustering) const {
    clustering.begin();
    for (const auto& line : line_segments) clustering.addLine(line.segments);
    clustering.finish();
  }

  /// A pixel takes its segment's plane; planes with too few pixels are dropped.
  int labelPixels(const DepthFrame& view, const PlaneClustering& clustering, int min_points,
                  std::vector<std::int32_t>& labels) const {
    std::vector<long> points(clustering.planes().size(), 0);
    forEachLabelled(clustering, [&](std::size_t plane, int, const LineSegments&, const LineSegment& segment) {
      points[plane] += segment.member_end - segment.member_begin;
    });
    std::vector<std::int32_t> label_of(points.size(), 0);
    std::int32_t count = 0;
    for (std::size_t plane = 0; plane < points.size(); ++plane)
      if (points[plane] > 0 && points[plane] >= min_points) label_of[plane] = ++count;
    forEachLabelled(clustering, [&](std::size_t plane, int column, const LineSegments& line, const LineSegment& s) {
      for (int i = s.member_begin; i < s.member_end; ++i)
        labels[view.index(line.members[static_cast<std::size_t>(i)], column)] = label_of[plane];
    });
    return count;
  }

 private:
  template <typename Visit>
  void forEachLabelled(const PlaneClustering& clustering, const Visit& visit) const {
    std::size_t next = 0;
    for (std::size_t column = 0; column < line_segments.size(); ++column)
      for (const auto& segment : line_segments[column].segments) {
        const int plane = clustering.labels()[next++];
        if (plane != PlaneClustering::kUnlabelled)
          visit(static_cast<std::size_t>(plane), static_cast<int>(column), line_segments[column], segment);
      }
  }
};

PlaneExtractor::PlaneExtractor(const Parameters& parameters, const SensorModel& sensor)
    : parameters_(parameters), sensor_(sensor), workspace_(std::make_unique<Workspace>()) {}
PlaneExtractor::~PlaneExtractor() = default;
PlaneExtractor::PlaneExtractor(PlaneExtractor&&) noexcept = default;
PlaneExtractor& PlaneExtractor::operator=(PlaneExtractor&&) noexcept = default;

bool PlaneExtractor::extract(const DepthFrame& frame, PlaneSegmentation& result) {
  prepare(frame, result);
  if (!error_.empty()) return false;
  const DepthFrame view = parameters_.scan == ScanDirection::Rows ? frame.transposed() : frame;
  auto clock = std::chrono::steady_clock::now();

  workspace_->clusterLines(view, sensor_, parameters_);  // Algorithm 1
  times_.lines = secondsSince(clock);

  PlaneClustering clustering(parameters_.plane, sensor_, view.projection());
  workspace_->clusterPlanes(clustering);  // Algorithm 2
  times_.planes = secondsSince(clock);

  const int count = workspace_->labelPixels(view, clustering, parameters_.plane.min_points, result.labels);
  fitPlanes(frame, sensor_, count, result);
  times_.result = secondsSince(clock);
  return true;
}

void PlaneExtractor::prepare(const DepthFrame& frame, PlaneSegmentation& result) {
  result.width = std::max(0, frame.width());
  result.height = std::max(0, frame.height());
  result.labels.assign(static_cast<std::size_t>(result.width) * static_cast<std::size_t>(result.height), 0);
  result.planes.clear();
  times_ = StageTimes();
  error_ = parameters_.validate();
  if (error_.empty()) error_ = sensor_.validate();
  if (error_.empty() && frame.empty()) error_ = "the frame is empty or its camera is invalid";
  if (error_.empty() && frame.projection() == Projection::Spherical && parameters_.scan == ScanDirection::Rows)
    error_ = "the rows of a spherical scan are cones, not planar sections: scan by columns";
}

}  // namespace epcc
