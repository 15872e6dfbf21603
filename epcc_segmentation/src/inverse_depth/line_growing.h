// SPDX-License-Identifier: BSD-3-Clause
// S1: one pass over a scan line's inverse depths gives line segments.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "epcc_segmentation/parameters.h"
#include "inverse_depth/inverse_depth_image.h"

namespace epcc {

/// Additive sums of the samples (x, w) of a line, x the ray coordinate along the scan line,
/// each of weight 1/sigma_w^2.
struct LineSums {
  double n = 0.0;
  double variance = 0.0;  ///< sum of sigma_w^2
  double w_plain = 0.0;   ///< sum of w
  double one = 0.0, x = 0.0, xx = 0.0, w = 0.0, xw = 0.0, ww = 0.0;

  void add(double sample_x, double sample_w, double sigma2) { add(sample_x, sample_w, sigma2, 1.0 / sigma2); }
  void add(double sample_x, double sample_w, double sigma2, double weight) {
    n += 1.0;
    variance += sigma2;
    w_plain += sample_w;
    one += weight;
    x += weight * sample_x;
    xx += weight * sample_x * sample_x;
    w += weight * sample_w;
    xw += weight * sample_x * sample_w;
    ww += weight * sample_w * sample_w;
  }
  /// Sxx, Sxw and Sww times `one`: their ratios are those of the spreads, without a division.
  double scaledSxx() const { return one * xx - x * x; }
  double scaledSxw() const { return one * xw - x * w; }
  double scaledSww() const { return one * ww - w * w; }
  double meanX() const { return x / one; }
  double meanW() const { return w / one; }
  double meanVariance() const { return variance / n; }
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
  explicit LineGrowing(const LineGrowingParameters& parameters) : parameters_(parameters) {}

  /// w: `count` inverse depths, 0 = invalid; x: their ray coordinate; scale: measured inverse depth = w * scale,
  /// by `scale[i]` or, if null, 1. Segments are appended to `lines`; segment_of[i] receives
  /// first_id + index of the segment or -1.
  void grow(const float* w, const double* x, const double* scale, int count, const InverseDepthNoise& noise,
            std::int32_t first_id, std::vector<GrownLine>& lines, std::int32_t* segment_of);

 private:
  void weigh(const double* scale, const InverseDepthNoise& noise);
  int extendActive(int position);
  void pushOnBuffer(int position);
  bool startFromBuffer();
  void emit();
  void add(int position, LineSums& sums) const;

  LineGrowingParameters parameters_;
  // The scan line: samples, their variances and weights 1/sigma_w^2.
  int count_ = 0;
  const float* w_ = nullptr;
  const double* x_ = nullptr;
  std::vector<double> variance_, weight_;
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
