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
  std::vector<const ScanSample*> samples;
  LinePrototype prototype;
  LabelVotes votes;

  void add(const ScanSample& sample, std::int32_t label) {
    samples.push_back(&sample);
    prototype.statistics.add(sample.t);
    votes.add(label);
  }
  ClusteredLine lineIn(const ScanLine& scan_line) {
    prototype.normal = smallestEigenvector(prototype.statistics.covariance);
    prototype.resetVariance();
    ClusteredLine line;
    const ScanSample &first = *samples.front(), &last = *samples.back();
    line.first = first.position;
    line.last = last.position;
    line.prototype = prototype;
    line.a = scan_line.lift(prototype.project(first.t));
    line.b = scan_line.lift(prototype.project(last.t));
    return line;
  }
};

/// A sample of a scan line of the grid: the number of its segment, -1 none, and the column of its pixel.
struct GridSample {
  ScanSample sample;
  std::int32_t segment;
  int column;
};

/// The samples of a column of the grid, which are those of one column of the view, or where pixels are scattered lie
/// in a few adjacent ones.
void readGridColumn(const DepthFrame& view, const SensorModel& sensor, const GridSegmentNumbers& numbers,
                    int grid_column, ScanLine& line, std::vector<GridSample>& samples) {
  samples.clear();
  const GridSteps& steps = numbers.steps;
  if (numbers.pixels == nullptr) {
    const int column = std::min(grid_column * steps.across + steps.across / 2, view.width() - 1);
    readScanLine(view, sensor, column, line);
    for (const ScanSample& sample : line.samples) {
      const int grid_row = sampleAt(sample.position, steps.along, view.height());
      if (grid_row >= 0) samples.push_back({sample, numbers.at(grid_row, grid_column), column});
    }
    return;
  }
  const int rows = sampleCount(view.height(), steps.along);
  const int end = std::min((grid_column + 1) * steps.across, view.width());
  for (int column = grid_column * steps.across; column < end; ++column) {
    readScanLine(view, sensor, column, line);
    for (const ScanSample& sample : line.samples) {
      const int grid_row = std::min(sample.position / steps.along, rows - 1);
      const int pixel = sample.position * numbers.next_pixel_row + column * numbers.next_pixel_column;
      if (numbers.pixels[numbers.place(grid_row, grid_column)] == pixel)
        samples.push_back({sample, numbers.at(grid_row, grid_column), column});
    }
  }
  std::sort(samples.begin(), samples.end(),
            [](const GridSample& a, const GridSample& b) { return a.sample.position < b.sample.position; });
}

}  // namespace

void appendSegments(const DepthFrame& view, const SensorModel& sensor, const GridSegmentNumbers& segment_of,
                    const std::vector<std::int32_t>& labels, SegmentFitter& fitter,
                    std::vector<LineSegment>& segments) {
  ScanLine line;
  std::vector<GridSample> samples;
  const int columns = sampleCount(view.width(), segment_of.steps.across);
  fitter.setStride(segment_of.steps.along);
  for (int grid_column = 0; grid_column < columns; ++grid_column) {
    readGridColumn(view, sensor, segment_of, grid_column, line, samples);
    GatheredSegment segment;
    int column = 0;  // of its first sample
    const auto finish = [&] {
      if (segment.samples.empty()) return;
      segments.push_back(lineSegmentOf(view, column, segment.lineIn(line)));
      fitter.fit(segment.samples, segments.back());
      segments.back().label = segment.votes.winner();
      segment = GatheredSegment();
    };
    std::int32_t current = -1;  // the samples of a segment follow each other, but for rejected ones between them
    for (const GridSample& sample : samples) {
      if (sample.segment < 0) continue;
      if (sample.segment != current) {
        finish();
        column = sample.column;
      }
      current = sample.segment;
      segment.add(sample.sample, labels[view.index(sample.sample.position, sample.column)]);
    }
    finish();
  }
}

}  // namespace epcc
