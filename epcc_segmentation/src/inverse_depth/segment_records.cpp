// SPDX-License-Identifier: BSD-3-Clause
// Gathers the samples of each segment of S1 again and fits a metric line to them.
#include "inverse_depth/segment_records.h"

#include <algorithm>

#include "inverse_depth/inverse_depth_image.h"
#include "metric/scan_line.h"
#include "metric/segment_record.h"

namespace epcc {
namespace {

/// The most frequent label of a segment's samples; of equally frequent ones that of the larger plane.
class LabelVotes {
 public:
  void add(std::int32_t label) {
    const auto found = std::find_if(votes_.begin(), votes_.end(), [label](const Vote& v) { return v.label == label; });
    if (found == votes_.end())
      votes_.push_back({label, 1});
    else
      ++found->count;
  }
  std::int32_t winner() const {
    return std::max_element(votes_.begin(), votes_.end(),
                            [](const Vote& a, const Vote& b) {
                              if (a.count != b.count) return a.count < b.count;
                              return b.label != 0 && (a.label == 0 || a.label > b.label);
                            })
        ->label;
  }

 private:
  struct Vote {
    std::int32_t label;
    int count;
  };
  std::vector<Vote> votes_;  // a segment has samples of few planes
};

/// What is known of one segment.
struct GatheredSegment {
  const ScanSample* first = nullptr;
  const ScanSample* last = nullptr;
  LinePrototype prototype;
  LabelVotes votes;

  void add(const ScanSample& sample, std::int32_t label) {
    if (first == nullptr) first = &sample;
    last = &sample;
    prototype.statistics.add(sample.t);
    votes.add(label);
  }
  ClusteredLine lineIn(const ScanLine& scan_line) {
    prototype.normal = smallestEigenvector(prototype.statistics.covariance);
    prototype.resetVariance();
    ClusteredLine line;
    line.first = first->position;
    line.last = last->position;
    line.prototype = prototype;
    line.a = scan_line.lift(prototype.project(first->t));
    line.b = scan_line.lift(prototype.project(last->t));
    return line;
  }
};

}  // namespace

void appendSegments(const DepthFrame& view, const SensorModel& sensor, const SegmentNumbers& segment_of,
                    const std::vector<std::int32_t>& labels, std::vector<LineSegment>& segments) {
  ScanLine line;
  for (int column = 0; column < view.width(); ++column) {
    const int grid_column = sampleAt(column, segment_of.stride, view.width());
    if (grid_column < 0) continue;
    readScanLine(view, sensor, column, line);
    GatheredSegment segment;
    const auto finish = [&] {
      if (segment.first == nullptr) return;
      segments.push_back(lineSegmentOf(view, column, segment.lineIn(line)));
      segments.back().label = segment.votes.winner();
      segment = GatheredSegment();
    };
    std::int32_t current = -1;  // the samples of a segment follow each other, but for rejected ones between them
    for (const ScanSample& sample : line.samples) {
      const int grid_row = sampleAt(sample.position, segment_of.stride, view.height());
      const std::int32_t id = grid_row < 0 ? -1 : segment_of.at(grid_row, grid_column);
      if (id < 0) continue;
      if (id != current) finish();
      current = id;
      segment.add(sample, labels[view.index(sample.position, column)]);
    }
    finish();
  }
}

}  // namespace epcc
