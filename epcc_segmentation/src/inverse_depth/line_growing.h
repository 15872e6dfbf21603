// SPDX-License-Identifier: BSD-3-Clause
// S1: one pass over a scan line's inverse depths gives line segments.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "epcc_segmentation/parameters.h"

namespace epcc {

/// Additive sums of the samples (x, w) of a line, x the ray coordinate along the scan line,
/// each of weight 1/sigma_w^2.
struct LineSums {
  double n = 0.0;
  double one = 0.0, x = 0.0, xx = 0.0, w = 0.0, xw = 0.0, ww = 0.0;

  void add(double sample_x, double sample_w, double weight) {
    const double weighted_x = weight * sample_x;
    const double weighted_w = weight * sample_w;
    n += 1.0;
    one += weight;
    x += weighted_x;
    xx += weighted_x * sample_x;
    w += weighted_w;
    xw += weighted_x * sample_w;
    ww += weighted_w * sample_w;
  }
  /// Sxx, Sxw and Sww times `one`: their ratios are those of the spreads, without a division.
  double scaledSxx() const { return one * xx - x * x; }
  double scaledSxw() const { return one * xw - x * w; }
  double scaledSww() const { return one * ww - w * w; }
  double meanX() const { return x / one; }
  double meanW() const { return w / one; }
  /// sigma_w^2 of a sample of mean weight.
  double meanVariance() const { return n / one; }
  double sxx() const { return xx - x * x / one; }
  double sxw() const { return xw - x * w / one; }
  double sww() const { return ww - w * w / one; }
  double slope() const {
    const double s = sxx();
    return s > 0.0 ? sxw() / s : 0.0;
  }
  /// Spread of x in plain units: (weighted) variance of x times n.
  double spread() const { return n * sxx() / one; }
  double rss() const {
    const double s = sxx();
    return s > 0.0 ? std::fmax(0.0, sww() - sxw() * sxw() / s) : std::fmax(0.0, sww());
  }
};

/// A line segment of one scan line: pixels first..last, but for the few rejected between them.
struct GrownLine {
  int first = 0;
  int last = 0;
  LineSums sums;
};

/// Grows the lines of one scan line.
class LineGrowing {
 public:
  explicit LineGrowing(const InverseDepthParameters& parameters) { configure(parameters); }
  void configure(const InverseDepthParameters& parameters) {
    k_max_ = parameters.line_k_max;
    parameters_ = parameters.expert.lines;
  }

  /// w: `count` inverse depths, 0 = invalid; weight: their 1/sigma_w^2; x: their ray coordinate. Segments are appended
  /// to `lines`; segment_of[i] receives first_id + index of the segment or -1.
  void grow(const float* w, const float* weight, const double* x, int count, std::int32_t first_id,
            std::vector<GrownLine>& lines, std::int32_t* segment_of);

 private:
  int extendActive(int position);
  void pushOnBuffer(int position);
  void startFromBuffer();
  void emit();
  void add(int position, LineSums& sums) const;

  double k_max_ = 0.0;
  InverseDepthParameters::Lines parameters_;
  // The scan line.
  int count_ = 0;
  const float* w_ = nullptr;
  const float* weight_ = nullptr;
  const double* x_ = nullptr;
  // The state of Algorithm 1: the active line and the positions of the last rejected samples.
  bool has_active_ = false;
  GrownLine active_;
  std::int32_t active_id_ = 0;
  std::vector<int> buffer_;
  // The results.
  std::vector<GrownLine>* lines_ = nullptr;
  std::int32_t* segment_of_ = nullptr;
};

}  // namespace epcc
