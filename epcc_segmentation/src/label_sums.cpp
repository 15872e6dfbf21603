// SPDX-License-Identifier: BSD-3-Clause
// Finds the runs of one label in a row and sums each in registers.
#include "label_sums.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "label_sums.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <cmath>

#include "label_runs-inl.h"
#include "run_sums-inl.h"
#include "sensor_variance-inl.h"
#include "vector/dispatch.h"

HWY_BEFORE_NAMESPACE();
namespace epcc {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
namespace {

using Totals = hn::CappedTag<double, kSumLanes>;
using Total = hn::Vec<Totals>;
constexpr std::size_t kTotalLanes = hn::MaxLanes(Totals());

HWY_INLINE void addTo(Total sum, double* total) {
  const Totals d;
  hn::StoreU(hn::Add(hn::LoadU(d, total), sum), d, total);
}

/// Lanes `lane` and `lane + kSumLanes` of a run's sum.
HWY_INLINE Total fold(const double* sum, std::size_t lane) {
  const Totals d;
  return hn::Add(hn::LoadU(d, sum + lane), hn::LoadU(d, sum + lane + kSumLanes));
}

/// Adds the sums 1, x, z, xx, xz, zz along an image row. Its rays share v = y/z, so that y - y0 = v (z - z0) + c there,
/// and the sums with y follow from the others.
HWY_INLINE void addRaySums(const double (*run)[kRunLanes], double along, double offset, double (*totals)[kSumLanes]) {
  const Totals d;
  const Total v = hn::Set(d, along);
  const Total c = hn::Set(d, offset);
  for (std::size_t lane = 0; lane < kSumLanes; lane += kTotalLanes) {
    const Total one = fold(run[0], lane), x = fold(run[1], lane), z = fold(run[2], lane);
    const Total xx = fold(run[3], lane), xz = fold(run[4], lane), zz = fold(run[5], lane);
    const Total y = hn::Add(hn::Mul(v, z), hn::Mul(c, one));
    const Total yz = hn::Add(hn::Mul(v, zz), hn::Mul(c, z));
    addTo(one, totals[0] + lane);
    addTo(x, totals[1] + lane);
    addTo(y, totals[2] + lane);
    addTo(z, totals[3] + lane);
    addTo(xx, totals[4] + lane);
    addTo(hn::Add(hn::Mul(v, xz), hn::Mul(c, x)), totals[5] + lane);
    addTo(xz, totals[6] + lane);
    addTo(hn::Add(hn::Mul(v, yz), hn::Mul(c, y)), totals[7] + lane);
    addTo(yz, totals[8] + lane);
    addTo(zz, totals[9] + lane);
  }
}

HWY_INLINE void addPointSums(const double (*run)[kRunLanes], double (*totals)[kSumLanes]) {
  for (std::size_t lane = 0; lane < kSumLanes; lane += kTotalLanes)
    for (int k = 0; k < kSums; ++k) addTo(fold(run[k], lane), totals[k] + lane);
}

/// The first point becomes the origin.
HWY_INLINE void start(const SampleRow& row, std::size_t first, LabelSums& sums) {
  const auto z = static_cast<double>(row.z[first]);
  sums.origin[0] = row.x != nullptr ? static_cast<double>(row.x[first]) : z * row.across[first];
  sums.origin[1] = row.x != nullptr ? static_cast<double>(row.y[first]) : z * row.along;
  sums.origin[2] = z;
  sums.started = true;
  for (auto& lanes : sums.lanes)
    for (double& lane : lanes) lane = 0.0;
}

template <bool kWeighted>
HWY_INLINE void addRun(const SampleRow& row, std::size_t begin, std::size_t end, LabelSums& sums) {
  if (!sums.started) start(row, begin, sums);
  const float* weight = kWeighted ? row.weight + begin : nullptr;
  double own[2 * kSums][kRunLanes];
  if (row.x == nullptr) {
    sumRays<kWeighted>({end - begin, weight, nullptr, nullptr, row.z + begin, row.across + begin}, sums.origin, own);
    const double offset = row.along * sums.origin[2] - sums.origin[1];
    addRaySums(own, row.along, offset, sums.lanes);
    if (kWeighted) addRaySums(own + kRaySums, row.along, offset, sums.lanes + kSums);
  } else {
    sumPoints<kWeighted>({end - begin, weight, row.x + begin, row.y + begin, row.z + begin, nullptr}, sums.origin, own);
    addPointSums(own, sums.lanes);
    if (kWeighted) addPointSums(own + kSums, sums.lanes + kSums);
  }
}

/// Negative if the label is not one of 0 .. label_count.
HWY_INLINE std::int32_t strayBit(std::int32_t label, std::int32_t label_count) {
  return label < 0 || label > label_count ? -1 : 0;
}

/// row.measured without weights; the compiler makes vectors of plain loops. True if there is a stray label.
bool markMeasured(const SampleRow& samples, std::int32_t label_count) {
  const SampleRow row = samples;
  std::int32_t stray = 0;
  for (std::size_t i = 0; i < row.count; ++i) stray |= strayBit(row.labels[i], label_count);
  if (row.x == nullptr) {
    for (std::size_t i = 0; i < row.count; ++i) row.measured[i] = row.z[i] > 0.0f ? row.labels[i] : 0;
  } else if (row.depth_is_range) {
    for (std::size_t i = 0; i < row.count; ++i)
      row.measured[i] = row.x[i] != 0.0f || row.y[i] != 0.0f || row.z[i] != 0.0f ? row.labels[i] : 0;
  } else {
    for (std::size_t i = 0; i < row.count; ++i) row.measured[i] = row.z[i] != 0.0f ? row.labels[i] : 0;
  }
  return stray < 0;
}

/// 1 / sigma_z^2 of a sample, and its label if it is measured, else 0.
HWY_INLINE void weighSample(const SampleRow& row, const SensorVariance& v, std::size_t i) {
  float depth = row.z[i];
  if (row.x != nullptr)
    depth = row.depth_is_range ? std::sqrt((row.x[i] * row.x[i] + row.y[i] * row.y[i]) + row.z[i] * row.z[i])
                               : std::abs(row.z[i]);
  const float polynomial = (v.k0 * depth + v.k1) * depth + v.k2;
  const float spread = polynomial > 0.0f ? polynomial : 0.0f;
  const float sum = spread * spread + v.floor;
  const float least = sum > v.smallest ? sum : v.smallest;
  row.weight[i] = 1.0f / (least < v.largest ? least : v.largest);
  row.measured[i] = depth > 0.0f ? row.labels[i] : 0;
}

#if HWY_TARGET == HWY_EMU128  // the compiler makes vectors of a plain loop, but not of emulated masks

bool weighSamples(const SampleRow& samples, const SensorVariance& variance, std::int32_t label_count) {
  const SampleRow row = samples;
  const SensorVariance v = variance;
  std::int32_t stray = 0;
  for (std::size_t i = 0; i < row.count; ++i) stray |= strayBit(row.labels[i], label_count);
  for (std::size_t i = 0; i < row.count; ++i) weighSample(row, v, i);
  return stray < 0;
}

#else

using Floats = hn::ScalableTag<float>;
using FloatVector = hn::Vec<Floats>;

HWY_INLINE FloatVector depthOf(const SampleRow& row, std::size_t i) {
  const Floats d;
  const FloatVector z = hn::LoadU(d, row.z + i);
  if (row.x == nullptr) return z;
  if (!row.depth_is_range) return hn::Abs(z);
  const FloatVector x = hn::LoadU(d, row.x + i), y = hn::LoadU(d, row.y + i);
  return hn::Sqrt(hn::Add(hn::Add(hn::Mul(x, x), hn::Mul(y, y)), hn::Mul(z, z)));
}

/// True if there is a label that is not one of 0 .. label_count.
bool weighSamples(const SampleRow& samples, const SensorVariance& variance, std::int32_t label_count) {
  const SampleRow row = samples;
  const SensorVariance v = variance;
  const Floats d;
  const hn::RebindToSigned<Floats> whole;
  constexpr std::size_t kStep = hn::MaxLanes(d);
  auto outside = hn::Zero(whole);
  std::size_t i = 0;
  for (; i + kStep <= row.count; i += kStep) {
    const FloatVector depth = depthOf(row, i);
    hn::StoreU(hn::Div(hn::Set(d, 1.0f), varianceOf(d, v, depth)), d, row.weight + i);
    const auto label = hn::LoadU(whole, row.labels + i);
    outside = hn::Or(outside, hn::Or(label, hn::Sub(hn::Set(whole, label_count), label)));  // the sign of both
    const auto measured = hn::RebindMask(whole, hn::Gt(depth, hn::Zero(d)));
    hn::StoreU(hn::IfThenElseZero(measured, label), whole, row.measured + i);
  }
  bool stray = !hn::AllFalse(whole, hn::Lt(outside, hn::Zero(whole)));
  for (; i < row.count; ++i) {
    weighSample(row, v, i);
    stray = stray || strayBit(row.labels[i], label_count) < 0;
  }
  return stray;
}

#endif

template <bool kWeighted>
void sumRuns(const SampleRow& row, std::int32_t label_count, LabelSums* sums) {
  forEachRun(row.measured, row.count, [&](std::size_t begin, std::size_t end) HWY_ATTR {
    const std::int32_t label = row.measured[begin];
    if (label >= 1 && label <= label_count) addRun<kWeighted>(row, begin, end, sums[label - 1]);
  });
}

bool sumRow(const SampleRow& row, const SensorVariance& variance, std::int32_t label_count, LabelSums* sums) {
  if (row.weight == nullptr) {
    const bool stray = markMeasured(row, label_count);
    sumRuns<false>(row, label_count, sums);
    return stray;
  }
  const bool stray = weighSamples(row, variance, label_count);
  sumRuns<true>(row, label_count, sums);
  return stray;
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace epcc
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace epcc {

namespace {
HWY_EXPORT(sumRow);
}

bool addToLabelSums(const SampleRow& row, const SensorVariance& variance, std::int32_t label_count, LabelSums* sums) {
  return EPCC_KERNEL(sumRow)(row, variance, label_count, sums);
}

}  // namespace epcc
#endif
