// SPDX-License-Identifier: BSD-3-Clause
// Samples and prototypes of one scan line, in the arithmetic of the vectors; part of the kernel of Algorithm 1.
#if defined(EPCC_METRIC_LINE_LANE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef EPCC_METRIC_LINE_LANE_INL_H_
#undef EPCC_METRIC_LINE_LANE_INL_H_
#else
#define EPCC_METRIC_LINE_LANE_INL_H_
#endif

#include <hwy/highway.h>

#include "metric/line_clustering.h"

HWY_BEFORE_NAMESPACE();
namespace epcc {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
namespace {

/// Where the scatter is less than this, samples coincide and the normal is arbitrary.
constexpr float kSmallestNormal = 1e-12f;

struct LineSample {
  float t1, t2, ray1, ray2, variance;
};

/// One lane of the active prototypes, or a candidate.
struct LinePrototypeLane {
  float n, mean1, mean2, s11, s22, s12, residuals, normal1, normal2, normal_squared;
};

HWY_INLINE float maxOf(float a, float b) {
  return a > b ? a : b;
}

HWY_INLINE float squareRoot(float x) {
  const hwy::HWY_NAMESPACE::CappedTag<float, 1> d;
  return hwy::HWY_NAMESPACE::GetLane(hwy::HWY_NAMESPACE::Sqrt(hwy::HWY_NAMESPACE::Set(d, x)));
}

HWY_INLINE bool isMeasured(float t1, float t2) {
  return t1 > 0.0f && t1 <= kFarthest && t2 <= kFarthest && -t2 <= kFarthest;
}

HWY_INLINE float varianceOf(const SensorVariance& v, float z) {
  const float spread = maxOf((v.k0 * z + v.k1) * z + v.k2, 0.0f);
  const float variance = maxOf(spread * spread + v.floor, v.smallest);
  return variance < v.largest ? variance : v.largest;
}

/// (t1, t2) of a pixel alone.
HWY_INLINE void readSection(const ScanStrip& strip, int row, int line, float& t1, float& t2) {
  const std::size_t at = static_cast<std::size_t>(row) * strip.stride + static_cast<std::size_t>(line);
  const float z = strip.z[at];
  if (strip.x == nullptr) {
    t1 = z * strip.secant[line];
    t2 = z * strip.along[row];
  } else {
    t1 = squareRoot(strip.x[at] * strip.x[at] + z * z);
    t2 = strip.y[at];
  }
}

/// The sample of a measured pixel as the vectors have it.
HWY_INLINE LineSample readSample(const ScanStrip& strip, const ClusteringRule& rule, int row, int line) {
  const std::size_t at = static_cast<std::size_t>(row) * strip.stride + static_cast<std::size_t>(line);
  const float z = strip.z[at];
  LineSample s;
  readSection(strip, row, line, s.t1, s.t2);
  if (strip.x == nullptr) {
    s.ray1 = strip.secant[line];
    s.ray2 = strip.along[row];
    s.variance = varianceOf(rule.variance, z);
    return s;
  }
  const float squared = strip.x[at] * strip.x[at] + z * z;
  const float depth = strip.depth_is_range ? squareRoot(squared + s.t2 * s.t2) : z;
  const float inverse = 1.0f / depth;
  s.ray1 = s.t1 * inverse;
  s.ray2 = s.t2 * inverse;
  s.variance = varianceOf(rule.variance, depth);
  return s;
}

/// Eqs. 12 and 13.
HWY_INLINE void addSample(const LineSample& s, LinePrototypeLane& p) {
  const float share = 1.0f / (p.n + 1.0f);
  const float grown = p.n * share;
  const float dx = s.t1 - p.mean1;
  const float dy = s.t2 - p.mean2;
  p.n += 1.0f;
  p.mean1 += dx * share;
  p.mean2 += dy * share;
  const float grown_x = dx * grown;
  p.s11 += grown_x * dx;
  p.s12 += grown_x * dy;
  p.s22 += dy * grown * dy;
}

/// Normal, and the variance of the residuals := the smaller eigenvalue.
HWY_INLINE void finishFit(LinePrototypeLane& p) {
  const float half = 0.5f * (p.s11 - p.s22);
  const float root = squareRoot(half * half + p.s12 * p.s12);
  const float large = maxOf((half < 0.0f ? -half : half) + root, kSmallestNormal);
  p.normal1 = half > 0.0f ? -p.s12 : large;
  p.normal2 = half > 0.0f ? large : -p.s12;
  p.normal_squared = p.normal1 * p.normal1 + p.normal2 * p.normal2;
  const float along1 = p.s11 * p.normal1 + p.s12 * p.normal2;
  const float along2 = p.s12 * p.normal1 + p.s22 * p.normal2;
  p.residuals = maxOf((p.normal1 * along1 + p.normal2 * along2) / p.normal_squared, 0.0f);
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace epcc
HWY_AFTER_NAMESPACE();

#endif
