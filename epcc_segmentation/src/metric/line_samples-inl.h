// SPDX-License-Identifier: BSD-3-Clause
// Reads a row of neighbouring scan lines as samples of their sections; part of the kernel of Algorithm 1.
#if defined(EPCC_METRIC_LINE_SAMPLES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef EPCC_METRIC_LINE_SAMPLES_INL_H_
#undef EPCC_METRIC_LINE_SAMPLES_INL_H_
#else
#define EPCC_METRIC_LINE_SAMPLES_INL_H_
#endif

#include <hwy/highway.h>

#include "metric/line_clustering.h"
#include "sensor_variance-inl.h"
#include "vector/extremes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace epcc {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
namespace {

using Float = hn::CappedTag<float, kStripLines / 2>;
using Int = hn::RebindToSigned<Float>;
using VF = hn::Vec<Float>;
using VI = hn::Vec<Int>;
using MF = hn::Mask<Float>;
constexpr int kLanes = static_cast<int>(hn::MaxLanes(Float()));

/// A sample of each lane. Structs of vectors have constructors here, for those that GCC makes itself lack the vector
/// unit's instructions, which on arm64 is an error.
struct Samples {
  VF t1, t2, ray1, ray2, variance;
  MF measured;

  HWY_INLINE Samples() {}
};

HWY_INLINE MF isMeasured(VF t1, VF t2) {
  const Float d;
  return hn::And(hn::Gt(t1, hn::Zero(d)), hn::Le(larger(t1, hn::Abs(t2)), hn::Set(d, kFarthest)));
}

/// Sections of a depth image: (t1, t2) = z (sqrt(1 + u^2), v).
HWY_INLINE Samples readDepths(const ScanStrip& strip, const ClusteringRule& rule, int row, int line) {
  const Float d;
  const VF z = hn::LoadU(d, strip.z + static_cast<std::size_t>(row) * strip.stride + line);
  Samples s;
  s.ray1 = hn::LoadU(d, strip.secant + line);
  s.ray2 = hn::Set(d, strip.along[row]);
  s.t1 = hn::Mul(z, s.ray1);
  s.t2 = hn::Mul(z, s.ray2);
  s.variance = varianceOf(d, rule.variance, z);
  s.measured = hn::Gt(z, hn::Zero(d));
  return s;
}

/// Sections of a cloud: (t1, t2) = (sqrt(x^2 + z^2), y); also sums the lines' directions.
HWY_INLINE Samples readPoints(const ScanStrip& strip, const ClusteringRule& rule, int row, int line, VF& sum_x,
                              VF& sum_z) {
  const Float d;
  const std::size_t at = static_cast<std::size_t>(row) * strip.stride + static_cast<std::size_t>(line);
  const VF x = hn::LoadU(d, strip.x + at);
  const VF z = hn::LoadU(d, strip.z + at);
  Samples s;
  const VF squared = hn::Add(hn::Mul(x, x), hn::Mul(z, z));
  s.t1 = hn::Sqrt(squared);
  s.t2 = hn::LoadU(d, strip.y + at);
  s.measured = isMeasured(s.t1, s.t2);
  const VF one = hn::Set(d, 1.0f);
  const VF range = strip.depth_is_range ? hn::Sqrt(hn::Add(squared, hn::Mul(s.t2, s.t2))) : z;
  const VF depth = hn::IfThenElse(s.measured, range, one);
  const VF inverse = hn::Div(one, depth);
  s.ray1 = hn::Mul(s.t1, inverse);
  s.ray2 = hn::Mul(s.t2, inverse);
  s.variance = varianceOf(d, rule.variance, depth);
  const VF inverse_t1 = hn::Div(one, hn::IfThenElse(s.measured, s.t1, one));
  sum_x = hn::Add(sum_x, hn::IfThenElseZero(s.measured, hn::Mul(x, inverse_t1)));
  sum_z = hn::Add(sum_z, hn::IfThenElseZero(s.measured, hn::Mul(z, inverse_t1)));
  return s;
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace epcc
HWY_AFTER_NAMESPACE();

#endif
