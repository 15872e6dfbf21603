// SPDX-License-Identifier: BSD-3-Clause
// S2: overlap and coplanarity with the previous scan line's planes.
#include "inverse_depth/plane_growing.h"

#include <algorithm>
#include <cmath>

#include "inverse_depth/plane_moments.h"

namespace epcc {

namespace {

constexpr int kMaxEmptyLines = 3;    // in a row, as in Algorithm 2
constexpr double kPriorSlope = 2.0;  // standard deviation of a plane's slopes

/// A segment as the comparison with a plane wants it: the line at mean_x +- h and the variances there.
struct ComparedLine {
  double mean_x, mean_w, slope;
  double h2, h;       // half the length of a uniform line of this spread
  double variance;    // sigma_w^2 of a sample
  double prediction;  // V0 + V1 h^2

  ComparedLine(const GrownLine& line, double pixels_per_line_sample, double sample_spread)
      : mean_x(static_cast<double>(line.mean_x)), mean_w(static_cast<double>(line.mean_w)) {
    const double n = line.n;
    const double sxx = static_cast<double>(line.sxx);
    variance = n / static_cast<double>(line.weight);
    const double spread = variance * sxx;
    slope = sxx > 0.0 ? static_cast<double>(line.sxw) / sxx : 0.0;
    h2 = 3.0 * spread / n;
    h = std::sqrt(h2);
    const double v0 = variance * std::min(1.0, pixels_per_line_sample / n);
    const double v1 = variance / (spread / pixels_per_line_sample + sample_spread);
    prediction = v0 + v1 * h2;
  }
};

}  // namespace

// The adjugate over the determinant.
SymmetricMatrix SymmetricMatrix::inverse() const {
  SymmetricMatrix a;
  a.ss = xx * ff - xf * xf;
  a.sx = sf * xf - sx * ff;
  a.sf = sx * xf - sf * xx;
  const double scale = 1.0 / (ss * a.ss + sx * a.sx + sf * a.sf);
  a.xx = (ss * ff - sf * sf) * scale;
  a.xf = (sx * sf - ss * xf) * scale;
  a.ff = (ss * xx - sx * sx) * scale;
  a.ss *= scale;
  a.sx *= scale;
  a.sf *= scale;
  return a;
}

void SegmentMoments::add(const ScanLineRays& at, const GrownLine& line) {
  const double weight = static_cast<double>(line.weight);
  const double mean_x = static_cast<double>(line.mean_x);
  const double x = weight * mean_x;
  const double w = weight * static_cast<double>(line.mean_w);
  n += line.n;
  rays.ss += weight * at.side * at.side;
  rays.sx += x * at.side;
  rays.sf += weight * at.side * at.forward;
  rays.xx += static_cast<double>(line.sxx) + x * mean_x;
  rays.xf += x * at.forward;
  rays.ff += weight * at.forward * at.forward;
  side_w += w * at.side;
  x_w += static_cast<double>(line.sxw) + w * mean_x;
  forward_w += w * at.forward;
}

void GrownPlane::fit() {
  SymmetricMatrix a = moments.rays;
  const AcrossDirection e = turning ? AcrossDirection(a.ss, a.sf, a.ff) : AcrossDirection();
  a.ss += ridge * e.xx;
  a.sf += ridge * e.xz;
  a.ff += ridge * e.zz;
  a.xx += ridge;
  inverse = a.inverse();
  q_side = inverse.ss * moments.side_w + inverse.sx * moments.x_w + inverse.sf * moments.forward_w;
  q_x = inverse.sx * moments.side_w + inverse.xx * moments.x_w + inverse.xf * moments.forward_w;
  q_forward = inverse.sf * moments.side_w + inverse.xf * moments.x_w + inverse.ff * moments.forward_w;
  fitted = true;
}

void PlaneGrowing::configure(const InverseDepthParameters& parameters, const SensorModel& sensor) {
  k_max_ = parameters.plane_k_max;
  parameters_ = parameters.expert.planes;
  pixels_per_sample_ = sensor.pixelsPerSample();
  pixels_per_line_sample_ = sensor.pixelsPerLineSample();
  correlation_length_ = sensor.correlationLength();
}

void PlaneGrowing::begin(double pixel_pitch, bool turning) {
  turning_ = turning;
  unknown_slope2_ = 0.0;
  sample_spread_ = std::pow(correlation_length_ * pixel_pitch, 2);
  previous_count_ = 0;
  previous_begin_ = 0;
  empty_lines_ = 0;
  plane_of_.clear();
  planes_.clear();
}

void PlaneGrowing::addLine(const ScanLineRays& rays, const GrownLine* lines, int count) {
  if (count == 0 && ++empty_lines_ <= kMaxEmptyLines) return;  // a line without a segment does not end a surface
  empty_lines_ = 0;
  const std::size_t begin = plane_of_.size();
  // Where rows are no scan lines nothing but its second segment can tell a plane's slope across the columns, and to an
  // exact sensor a slanted plane's second column is many sigma away.
  if (turning_)
    unknown_slope2_ = std::pow(2.0 * kPriorSlope, 2) * (std::pow(rays.side - previous_rays_.side, 2) +
                                                        std::pow(rays.forward - previous_rays_.forward, 2));
  int candidate = 0;  // no segment before it overlaps this line or a later one
  for (int k = 0; k < count; ++k) {
    const GrownLine& line = lines[k];
    while (candidate < previous_count_ && previous_[candidate].last < line.first) ++candidate;
    int best = findPlane(rays, line, candidate);
    if (best < 0) best = startPlane(line);
    GrownPlane& plane = planes_[static_cast<std::size_t>(best)];
    plane.moments.add(rays, line);
    plane.fitted = false;
    ++plane.segments;
    plane_of_.push_back(best);
  }
  previous_ = lines;
  previous_rays_ = rays;
  previous_count_ = count;
  previous_begin_ = begin;
}

int PlaneGrowing::startPlane(const GrownLine& line) {
  const auto w = static_cast<double>(line.mean_w);
  planes_.emplace_back();
  planes_.back().turning = turning_;
  planes_.back().ridge = pixels_per_sample_ / std::pow(kPriorSlope * w, 2);  // weak: slopes up to about 4
  return static_cast<int>(planes_.size()) - 1;
}

// The plane of an overlapping segment of the previous line with the least T < k_max^2, -1 if there is none. T is the
// squared difference of line and plane over its variance, at the worse end of an equivalent uniform line.
int PlaneGrowing::findPlane(const ScanLineRays& rays, const GrownLine& line, int first_candidate) {
  const double s = rays.side, f = rays.forward;
  double least = k_max_ * k_max_;
  int best = -1;
  for (int j = first_candidate; j < previous_count_ && previous_[j].first <= line.last; ++j) {
    const GrownLine& other = previous_[j];
    const int overlap = std::min(line.last, other.last) - std::max(line.first, other.first) + 1;
    const int shorter = std::min(line.last - line.first, other.last - other.first) + 1;
    if (overlap < parameters_.min_overlap_pixels || 2 * overlap < shorter) continue;
    const int index = plane_of_[previous_begin_ + static_cast<std::size_t>(j)];
    if (index == best) continue;
    GrownPlane& plane = planes_[static_cast<std::size_t>(index)];
    if (!plane.fitted) plane.fit();

    const ComparedLine c(line, pixels_per_line_sample_, sample_spread_);
    // Difference and prediction variance r^T P r at mean_x + o, as polynomials of o.
    const double difference = c.mean_w - (plane.q_side * s + plane.q_x * c.mean_x + plane.q_forward * f);
    const double difference_change = (c.slope - plane.q_x) * c.h;
    const SymmetricMatrix& p = plane.inverse;
    const double half_linear = p.sx * s + p.xf * f + p.xx * c.mean_x;
    const double constant =
        p.ss * s * s + p.ff * f * f + 2.0 * p.sf * s * f + c.mean_x * (half_linear + p.sx * s + p.xf * f);
    const double even = pixels_per_sample_ * (constant + p.xx * c.h2) + c.prediction;
    const double odd = pixels_per_sample_ * 2.0 * half_linear * c.h;
    const double most = std::max(parameters_.max_prediction * c.variance, c.mean_w * c.mean_w * unknown_slope2_);
    const double before = difference - difference_change, after = difference + difference_change;
    const double before2 = before * before, after2 = after * after;
    const double variance_before = c.variance + std::min(even - odd, most);
    const double variance_after = c.variance + std::min(even + odd, most);
    if (!(before2 < least * variance_before && after2 < least * variance_after)) continue;
    least = std::max(before2 / variance_before, after2 / variance_after);
    best = index;
  }
  return best;
}

}  // namespace epcc
