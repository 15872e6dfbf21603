// SPDX-License-Identifier: BSD-3-Clause
// A scan line is summed as a row of a frame is.
#include "stream/segment_sums.h"

#include "metric/line_clustering.h"

namespace epcc {

void SegmentSums::begin(int height, const SensorModel& sensor) {
  variance_ = SensorVariance(sensor);
  const auto samples = static_cast<std::size_t>(height);
  labels_.assign(samples, 0);
  measured_.assign(samples + kRunLanes, 0);
  weights_.assign(samples + kRunLanes, 0.0f);
}

void SegmentSums::readLabels(const std::int32_t* numbers, std::vector<PendingRun>& runs) {
  runs.clear();
  std::int32_t previous = 0;
  for (std::size_t i = 0; i < labels_.size(); ++i) {
    const std::int32_t number = numbers[i * kStripLines];
    const std::int32_t label = number == 0 ? 0 : (number - 1) / kStripLines + 1;
    labels_[i] = label;
    const auto place = static_cast<std::int32_t>(i);
    if (label != 0 && label == previous)
      runs.back().last = place;
    else if (label != 0)
      runs.push_back({place, place, label - 1});
    previous = label;
  }
}

void SegmentSums::sum(SampleRow row, const std::int32_t* numbers, int count, PendingLine& line) {
  line.segments.resize(static_cast<std::size_t>(count));
  line.runs.clear();
  if (count == 0) return;
  readLabels(numbers, line.runs);
  if (sums_.size() < line.segments.size()) sums_.resize(line.segments.size());
  for (std::size_t k = 0; k < line.segments.size(); ++k) sums_[k].started = false;
  row.labels = labels_.data();
  row.measured = measured_.data();
  row.weight = weights_.data();
  addToLabelSums(row, variance_, count, sums_.data());
  for (std::size_t k = 0; k < line.segments.size(); ++k) {
    line.segments[k].moments = PointMoments();
    line.segments[k].moments.add(sums_[k]);
  }
}

}  // namespace epcc
