// SPDX-License-Identifier: BSD-3-Clause
// The pipelines of both modes, step by step: scan lines -> line segments -> planes -> labels (Figure 2).
#include "epcc_segmentation/plane_extractor.h"

#include <algorithm>
#include <chrono>

#include "epcc_segmentation/plane_fit.h"
#include "inverse_depth/inverse_depth_pipeline.h"
#include "metric/metric_pipeline.h"

namespace epcc {

namespace {

/// Seconds since the last call or the construction.
class StopWatch {
 public:
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    const double seconds = std::chrono::duration<double>(now - last_).count();
    last_ = now;
    return seconds;
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

/// Labels in the frame's own order -> in that of the caller's arrays, which a transposed view does not share.
void moveLabels(const DepthFrame& frame, std::vector<std::int32_t>& from, std::vector<std::int32_t>& to) {
  if (!frame.isTransposed()) {
    to.swap(from);  // each keeps its memory
    return;
  }
  to.resize(from.size());
  std::size_t next = 0;
  for (int row = 0; row < frame.height(); ++row)
    for (int column = 0; column < frame.width(); ++column) to[frame.index(row, column)] = from[next++];
}

}  // namespace

/// Both pipelines' memory, kept from frame to frame.
struct PlaneExtractor::Workspace {
  Workspace(const Parameters& parameters, const SensorModel& sensor)
      : metric(parameters, sensor), inverse_depth(parameters, sensor) {}
  MetricPipeline metric;
  InverseDepthPipeline inverse_depth;
};

PlaneExtractor::PlaneExtractor(const Parameters& parameters, const SensorModel& sensor)
    : parameters_(parameters), sensor_(sensor), workspace_(std::make_unique<Workspace>(parameters, sensor)) {}
PlaneExtractor::~PlaneExtractor() = default;
PlaneExtractor::PlaneExtractor(PlaneExtractor&&) noexcept = default;
PlaneExtractor& PlaneExtractor::operator=(PlaneExtractor&&) noexcept = default;

bool PlaneExtractor::extract(const DepthFrame& frame, PlaneSegmentation& result) {
  prepare(frame, result);
  if (!error_.empty()) return false;
  const int count = parameters_.mode == Mode::Paper ? extractMetric(frame, result) : extractInverseDepth(frame, result);
  StopWatch watch;
  fitPlanes(frame, sensor_, count, result);
  times_.result += watch.lap();
  return true;
}

int PlaneExtractor::extractMetric(const DepthFrame& frame, PlaneSegmentation& result) {
  const DepthFrame view = parameters_.scan == ScanDirection::Rows ? frame.transposed() : frame;
  MetricPipeline& pipeline = workspace_->metric;
  StopWatch watch;
  pipeline.clusterLines(view);  // Algorithm 1
  times_.lines = watch.lap();
  pipeline.clusterPlanes(view);  // Algorithm 2
  times_.planes = watch.lap();
  const int count = pipeline.labelPixels(view, result.labels);
  times_.result = watch.lap();
  return count;
}

int PlaneExtractor::extractInverseDepth(const DepthFrame& frame, PlaneSegmentation& result) {
  InverseDepthPipeline& pipeline = workspace_->inverse_depth;
  StopWatch watch;
  pipeline.read(frame);
  times_.read = watch.lap();
  pipeline.growLines();  // S1
  times_.lines = watch.lap();
  pipeline.growPlanes();  // S2
  times_.planes = watch.lap();
  pipeline.joinDirections();    // S3
  pipeline.mergeRegions();      // S4
  pipeline.refineBoundaries();  // S5, S6
  pipeline.rejectClutter();     // S7
  pipeline.joinOccluded();      // S8
  times_.regions = watch.lap();
  moveLabels(frame, pipeline.labels(), result.labels);
  times_.result = watch.lap();
  return pipeline.labelCount();
}

void PlaneExtractor::prepare(const DepthFrame& frame, PlaneSegmentation& result) {
  result.width = std::max(0, frame.width());
  result.height = std::max(0, frame.height());
  result.planes.clear();
  times_ = StageTimes();
  error_ = parameters_.validate();
  if (error_.empty()) error_ = sensor_.validate();
  if (error_.empty() && frame.empty()) error_ = "the frame is empty or its camera is invalid";
  if (error_.empty() && frame.projection() == Projection::Spherical && parameters_.scan == ScanDirection::Rows)
    error_ = "the rows of a spherical scan are cones, not planar sections: scan by columns";
  if (error_.empty() && parameters_.mode == Mode::Default) return;  // which writes every label
  result.labels.assign(static_cast<std::size_t>(result.width) * static_cast<std::size_t>(result.height), 0);
}

}  // namespace epcc
