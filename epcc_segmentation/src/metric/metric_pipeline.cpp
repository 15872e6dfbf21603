// SPDX-License-Identifier: BSD-3-Clause
// The paper's two algorithms in sequence.
#include "metric/metric_pipeline.h"

#include <algorithm>
#include <atomic>
#include <numeric>

#include "metric/pixel_labels.h"
#include "metric/scan_line.h"
#include "metric/segment_record.h"
#include "worker_pool.h"

namespace epcc {

MetricPipeline::MetricPipeline(const Parameters& parameters, const SensorModel& sensor)
    : parameters_(parameters), sensor_(sensor), plane_clustering_(parameters.paper, sensor) {}

void MetricPipeline::configure(const Parameters& parameters, const SensorModel& sensor) {
  parameters_ = parameters;
  sensor_ = sensor;
  rule_ = ClusteringRule(parameters.paper, sensor);
  plane_clustering_.configure(parameters.paper, sensor);
}

void MetricPipeline::clusterLines(const DepthFrame& view) {
  strips_.begin(view);
  capacity_ = StripLines::capacity(view.height(), rule_);
  line_segments_.resize(static_cast<std::size_t>(view.width()));
  numbers_.resize(static_cast<std::size_t>(view.height()) * strips_.paddedWidth());
  const int threads = std::min(parameters_.threads, strips_.count());
  memory_.resize(static_cast<std::size_t>(threads));
  plane_clustering_.begin(view.projection());
  order_of_strips_.begin(strips_.count());
  std::atomic<int> next_thread{0};
  std::atomic<int> next_strip{0};
  onWorkers(threads, [&] {
    StripMemory& memory = memory_[static_cast<std::size_t>(next_thread++)];
    for (int strip = next_strip++; strip < strips_.count(); strip = next_strip++) {
      clusterStrip(view, strip, memory);
      // Algorithm 2 waits for nobody: it takes what is finished while the other threads are at later strips.
      if (threads > 1) order_of_strips_.finish(strip, [&](int finished) { clusterPlanesOf(finished); });
    }
  });
}

void MetricPipeline::clusterStrip(const DepthFrame& view, int strip, StripMemory& memory) {
  const int first = strip * kStripLines;
  const SegmentNumbers numbers{numberOf(first, 0), static_cast<std::int32_t>(numberStride()), numbers_.data() + first,
                               strips_.paddedWidth()};
  memory.lines.cluster(strips_.strip(view, strip, memory.samples), rule_, numbers);
  const int lines = std::min(kStripLines, view.width() - first);
  for (int i = 0; i < lines; ++i) {
    std::vector<ClusteredLine>& segments = line_segments_[static_cast<std::size_t>(first + i)];
    segments.clear();
    if (memory.lines.count(i) == 0) continue;
    memory.lines.list(i, strips_.direction(view, first + i, memory.lines.directionSum(i)), segments);
  }
}

void MetricPipeline::clusterPlanes() {
  for (int strip = order_of_strips_.taken(); strip < strips_.count(); ++strip) clusterPlanesOf(strip);
  plane_clustering_.finish();
}

void MetricPipeline::clusterPlanesOf(int strip) {
  const auto begin = static_cast<std::size_t>(strip) * kStripLines;
  const std::size_t end = std::min(begin + kStripLines, line_segments_.size());
  for (std::size_t column = begin; column < end; ++column) plane_clustering_.addLine(line_segments_[column]);
}

int MetricPipeline::labelPixels(const DepthFrame& view, std::vector<std::int32_t>& labels) {
  const int count = numberPlanes();
  label_of_number_.resize(strips_.paddedWidth() * static_cast<std::size_t>(capacity_) + 1);
  forEachSegment([&](int plane, std::int32_t number, const ClusteredLine&) {
    label_of_number_[static_cast<std::size_t>(number)] =
        plane == PlaneClustering::kUnlabelled ? 0 : label_of_plane_[static_cast<std::size_t>(plane)];
  });
  label_of_number_[0] = 0;
  labelOfNumbers(view, numbers_.data(), strips_.paddedWidth(), label_of_number_.data(), labels.data(),
                 parameters_.threads);
  return count;
}

// Label of each plane by its place in the order of size, the earlier one first of two alike; 0 of one that is dropped.
int MetricPipeline::numberPlanes() {
  points_.assign(plane_clustering_.planes().size(), 0);
  forEachSegment([&](int plane, std::int32_t, const ClusteredLine& segment) {
    if (plane != PlaneClustering::kUnlabelled)
      points_[static_cast<std::size_t>(plane)] += segment.prototype.statistics.n;
  });
  order_.resize(points_.size());
  std::iota(order_.begin(), order_.end(), std::size_t{0});
  std::sort(order_.begin(), order_.end(),
            [&](std::size_t i, std::size_t j) { return points_[i] != points_[j] ? points_[i] > points_[j] : i < j; });
  label_of_plane_.assign(points_.size(), 0);
  std::int32_t count = 0;
  for (const std::size_t plane : order_)
    if (points_[plane] > 0 && points_[plane] >= parameters_.paper.min_points) label_of_plane_[plane] = ++count;
  return count;
}

// Their statistics and ends again in double precision, from the samples that they took.
void MetricPipeline::listSegments(const DepthFrame& view, const std::vector<std::int32_t>& labels,
                                  SegmentFitter& fitter, std::vector<LineSegment>& segments) const {
  ScanLine scan_line;
  std::vector<const ScanSample*> samples;
  fitter.setStride(1);
  for (int column = 0; column < view.width(); ++column) {
    readScanLine(view, sensor_, column, scan_line);
    const auto& lines = line_segments_[static_cast<std::size_t>(column)];
    auto sample = scan_line.samples.begin();
    for (std::size_t k = 0; k < lines.size(); ++k) {
      ClusteredLine line = lines[k];
      LinePrototype& p = line.prototype;
      p.statistics = RecursiveStatistics<2>();
      samples.clear();
      for (; sample != scan_line.samples.end() && sample->position <= line.last; ++sample) {
        if (numbers_[static_cast<std::size_t>(sample->position) * numberStride() + static_cast<std::size_t>(column)] !=
            numberOf(column, k))
          continue;
        p.statistics.add(sample->t);
        samples.push_back(&*sample);
      }
      if (samples.empty()) continue;
      p.normal = smallestEigenvector(p.statistics.covariance);
      line.a = scan_line.lift(p.project(samples.front()->t));
      line.b = scan_line.lift(p.project(samples.back()->t));
      segments.push_back(lineSegmentOf(view, column, line));
      segments.back().label = labels[view.index(line.first, column)];  // all of its pixels have it
      fitter.fit(samples, segments.back());
    }
  }
}

// Calls visit(plane, number, segment) in the order of clustering.
template <typename Visit>
void MetricPipeline::forEachSegment(const Visit& visit) const {
  std::size_t next = 0;
  for (std::size_t column = 0; column < line_segments_.size(); ++column)
    for (std::size_t k = 0; k < line_segments_[column].size(); ++k)
      visit(plane_clustering_.labels()[next++], numberOf(static_cast<int>(column), k), line_segments_[column][k]);
}

}  // namespace epcc
