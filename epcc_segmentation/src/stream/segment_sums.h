// SPDX-License-Identifier: BSD-3-Clause
// Runs and sums of points of the segments of one scan line, while its samples are at hand.
#pragma once

#include <cstdint>
#include <vector>

#include "epcc_segmentation/sensor_model.h"
#include "label_sums.h"
#include "sensor_variance.h"
#include "stream/pending_lines.h"

namespace epcc {

/// Fills pending lines. Keeps its memory.
class SegmentSums {
 public:
  void begin(int height, const SensorModel& sensor);
  /// `numbers`: of each sample, kStripLines apart: k * kStripLines + 1 to (k + 1) * kStripLines in the k-th of `count`
  /// segments, 0 in none.
  void sum(SampleRow row, const std::int32_t* numbers, int count, PendingLine& line);

 private:
  void readLabels(const std::int32_t* numbers, std::vector<PendingRun>& runs);

  SensorVariance variance_;
  std::vector<std::int32_t> labels_;  // of each sample: its segment's place in the line + 1
  std::vector<std::int32_t> measured_;
  std::vector<float> weights_;
  std::vector<LabelSums> sums_;
};

}  // namespace epcc
