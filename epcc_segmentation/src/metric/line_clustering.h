// SPDX-License-Identifier: BSD-3-Clause
// Algorithm 1: one pass over the samples of many neighbouring scan lines at once gives their line segments.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "epcc_segmentation/paper_parameters.h"
#include "epcc_segmentation/sensor_model.h"
#include "sensor_variance.h"

namespace epcc {

/// Scan lines of a strip: neighbouring columns of a view, clustered side by side.
constexpr int kStripLines = 32;

/// Beyond so many metres squares leave single precision. What has a larger coordinate counts as not measured.
constexpr float kFarthest = 1e5f;

/// What Algorithm 1 decides by.
struct ClusteringRule {
  ClusteringRule() = default;
  ClusteringRule(const PaperParameters& parameters, const SensorModel& sensor);
  float k_max_squared = 0.0f;
  float projection_floor = 0.0f;
  SensorVariance variance;  ///< all zeros where the noise model is not to be used
  int fit_samples = 0;
  int validation_samples = 0;
  int buffer_samples = 0;
  int minSamples() const { return fit_samples + validation_samples; }
};

/// The samples of a strip: height rows of kStripLines lines each, `stride` floats apart; lines that are not there are
/// not measured.
struct ScanStrip {
  int height = 0;
  std::size_t stride = 0;
  const float* z = nullptr;  ///< forward; of a depth image 0 where nothing is measured, and within farthestDepth()
  /// Of a depth image: sqrt(1 + u^2) of every line and v of every row; else null.
  const float* secant = nullptr;
  const float* along = nullptr;
  /// Of a cloud: across and along, in the scan frame; all three are 0 where nothing is measured. Else null.
  const float* x = nullptr;
  const float* y = nullptr;
  bool depth_is_range = false;  ///< the measured value of a cloud is the range, not z
};

/// A finished segment. `scatter` is (n - 1) times the covariance, `residuals` (n - 1) times the variance of Eq. 11,
/// `normal` is not normalised.
struct LineRecord {
  int first, last;  // rows
  float n;
  float mean[2], scatter[3], residuals, normal[2];  // scatter: 11, 22, 12
  float first_sample[2], last_sample[2];            // (t1, t2)
};

/// What is found in a strip. The k-th segment of a line has the number first_number + k * number_step + line, k from 0:
/// then those of neighbouring lines lie side by side in tables.
struct StripSegments {
  int capacity = 0;               ///< of a line, at least height / k_min
  LineRecord* records = nullptr;  ///< capacity for each of the kStripLines lines
  int count[kStripLines] = {};
  float direction[kStripLines][2] = {};  ///< of a cloud: sum of the unit vectors (x, z) of t1
  std::int32_t first_number = 1;
  std::int32_t number_step = kStripLines;
  std::int32_t* numbers = nullptr;  ///< of each sample its segment's number, 0 none; rows of kStripLines lines
  std::size_t number_stride = 0;
};

/// Memory of one thread for the buffers of rejected samples.
class LineWorkspace {
 public:
  /// Floats for `count` arrays of `length` each.
  float* floats(std::size_t count, std::size_t length) {
    if (memory_.size() < count * length) memory_.resize(count * length);
    return memory_.data();
  }

 private:
  std::vector<float> memory_;
};

/// Largest depth of an image at which no coordinate is beyond kFarthest; `slope` is its largest secant or v.
inline float farthestDepth(float slope) {
  return kFarthest / slope;
}

/// Clusters the first `lines` lines of the strip; those behind them, whose samples are not measured, may be left out.
void clusterLines(const ScanStrip& strip, const ClusteringRule& rule, LineWorkspace& workspace, StripSegments& result,
                  int lines = kStripLines);

}  // namespace epcc
