// SPDX-License-Identifier: BSD-3-Clause
// S1: one pass over scan lines' inverse depths gives line segments, many scan lines at a time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "epcc_segmentation/parameters.h"

namespace epcc {

/// A line segment of one scan line: pixels first..last, but for the few rejected between them. Statistics of its
/// samples (x, w), x the ray coordinate along the scan line, each of weight 1/sigma_w^2.
struct GrownLine {
  std::int32_t first = 0;
  std::int32_t last = 0;
  std::int32_t n = 0;
  float weight = 0.0f;  ///< sum of the weights
  float mean_x = 0.0f, mean_w = 0.0f;
  float sxx = 0.0f, sxw = 0.0f;  ///< about the means
};

/// Adjacent scan lines, side by side in memory, and the places of their results.
struct ScanLines {
  static constexpr int kCount =
      32;  ///< at a time: two vectors of the widest unit, to hide the latency of the recursion

  const float* w = nullptr;       ///< the first samples of all lines, 0 = invalid
  const float* weight = nullptr;  ///< 1/sigma_w^2 of each, positive where w is
  std::size_t pitch = 0;          ///< from a line's sample to its next, here and in `segment`
  const float* x = nullptr;       ///< per sample: its ray coordinate
  int length = 0;                 ///< samples of a line

  std::int32_t* segment = nullptr;  ///< per sample: the number of its segment within its scan line, -1 none
  GrownLine* lines = nullptr;       ///< `capacity` for each scan line
  int capacity = 0;                 ///< see LineGrowing::mostLines()
  std::int32_t* line_count = nullptr;
};

/// A value of each of ScanLines::kCount lines, aligned for any vector.
template <typename T>
struct alignas(64) ValuesOfLines {
  T values[ScanLines::kCount];
};

/// Grows the lines of scan lines. Keeps its memory.
class LineGrowing {
 public:
  explicit LineGrowing(const InverseDepthParameters& parameters) { configure(parameters); }
  void configure(const InverseDepthParameters& parameters) {
    k_max_ = static_cast<float>(parameters.line_k_max);
    parameters_ = parameters.expert.lines;
  }

  /// No scan line of so many samples has more segments: each takes min_samples of them.
  int mostLines(int length) const { return length / parameters_.min_samples; }
  /// For scan lines of so many samples; grow() does it, too.
  void makeRoom(int length);
  /// Of ScanLines::kCount lines.
  void grow(const ScanLines& scan_lines);

 private:
  /// Of rejected samples, as many as may matter: a power of two.
  int ringFor(int length) const;

  float k_max_ = 0.0f;
  InverseDepthParameters::Lines parameters_;
  std::vector<ValuesOfLines<float>> rejected_;  // weights of the last rejected samples
};

}  // namespace epcc
