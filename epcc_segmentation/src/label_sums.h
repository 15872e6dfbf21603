// SPDX-License-Identifier: BSD-3-Clause
// Sums over the points of each label, row by row, in vector lanes of double precision.
#pragma once

#include <cstddef>
#include <cstdint>

#include "sensor_variance.h"

namespace epcc {

/// Lanes of the sums, whatever the vector unit. Of a run of one label sample i goes to lane i % kRunLanes; then lane k
/// of the run goes to lane k % kSumLanes of the label's sums.
constexpr int kRunLanes = 8;
constexpr int kSumLanes = 4;

/// 1, x, y, z, xx, xy, xz, yy, yz, zz, then the same weighted by 1 / sigma_z^2.
constexpr int kSums = 10;

/// Sums of a label about its first point, where double precision loses nothing; nothing yet until `started`.
struct LabelSums {
  double lanes[2 * kSums][kSumLanes];
  double origin[3];
  bool started = false;
};

/// Samples of an image row with their labels: depths with the slopes of their rays, or points. Of the coordinates and
/// of the weights up to kRunLanes values behind the last may be read.
struct SampleRow {
  std::size_t count = 0;
  const std::int32_t* labels = nullptr;
  const float* z = nullptr;  ///< of a depth image 0 where nothing is measured
  /// Of a depth image: u of each sample and the row's v.
  const double* across = nullptr;
  double along = 0.0;
  /// Of a cloud, else null; all three are 0 where nothing is measured.
  const float* x = nullptr;
  const float* y = nullptr;
  bool depth_is_range = false;
  /// Memory for each sample's weight, null for plain sums alone, and, if it is measured, its label.
  float* weight = nullptr;
  std::int32_t* measured = nullptr;
};

/// Adds a row to sums[0 .. label_count) of the labels 1 .. label_count. True if there was another label but 0.
bool addToLabelSums(const SampleRow& row, const SensorVariance& variance, std::int32_t label_count, LabelSums* sums);

}  // namespace epcc
