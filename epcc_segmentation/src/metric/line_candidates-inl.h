// SPDX-License-Identifier: BSD-3-Clause
// The rejected samples of one scan line and the new segments that may start among them; part of the kernel of
// Algorithm 1, compiled for each vector unit.
#if defined(EPCC_METRIC_LINE_CANDIDATES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef EPCC_METRIC_LINE_CANDIDATES_INL_H_
#undef EPCC_METRIC_LINE_CANDIDATES_INL_H_
#else
#define EPCC_METRIC_LINE_CANDIDATES_INL_H_
#endif

#include <hwy/highway.h>

#include "metric/line_lane-inl.h"
#include "sensor_variance-inl.h"
#include "vector/extremes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace epcc {
namespace HWY_NAMESPACE {
namespace {

/// Rejected samples in order, begin to end, and the candidates that start at each: those up to `fitted` are fitted and
/// have counted every sample so far that agrees with them. Fields lie apart, for all samples are tested against one
/// candidate, and all candidates against one sample, in vectors.
struct SampleBuffer {
  enum Field {
    kT1,
    kT2,
    kRay1,
    kRay2,
    kVariance,
    kMean1,
    kMean2,
    kS11,
    kS22,
    kS12,
    kResiduals,
    kNormal1,
    kNormal2,
    kNormalSquared,
    kFields
  };
  enum Count { kRow, kAgreeing, kCounts };
  static constexpr int kPadding = 16;  // a vector may read beyond the end
  int capacity = 0, begin = 0, end = 0, fitted = 0;
  float* fields[kFields];
  std::int32_t* counts[kCounts];

  static std::size_t length(const ClusteringRule& rule) {
    return static_cast<std::size_t>(2 * rule.buffer_samples + kPadding);
  }
  static std::size_t floats(const ClusteringRule& rule) {
    return (std::size_t{kFields} + std::size_t{kCounts}) * length(rule);
  }
  float* place(float* memory, const ClusteringRule& rule) {
    capacity = 2 * rule.buffer_samples;
    for (float*& field : fields) {
      field = memory;
      memory += length(rule);
    }
    for (std::int32_t*& count : counts) {
      count = reinterpret_cast<std::int32_t*>(memory);
      memory += length(rule);
    }
    return memory;
  }
  LineSample sample(int i) const {
    return {fields[kT1][i], fields[kT2][i], fields[kRay1][i], fields[kRay2][i], fields[kVariance][i]};
  }
  void setSample(int i, const LineSample& s, int row) {
    fields[kT1][i] = s.t1;
    fields[kT2][i] = s.t2;
    fields[kRay1][i] = s.ray1;
    fields[kRay2][i] = s.ray2;
    fields[kVariance][i] = s.variance;
    counts[kRow][i] = row;
  }
  LinePrototypeLane candidate(int i, const ClusteringRule& rule) const {
    return {static_cast<float>(rule.fit_samples),
            fields[kMean1][i],
            fields[kMean2][i],
            fields[kS11][i],
            fields[kS22][i],
            fields[kS12][i],
            fields[kResiduals][i],
            fields[kNormal1][i],
            fields[kNormal2][i],
            fields[kNormalSquared][i]};
  }
  void setCandidate(int i, const LinePrototypeLane& p) {
    fields[kMean1][i] = p.mean1;
    fields[kMean2][i] = p.mean2;
    fields[kS11][i] = p.s11;
    fields[kS22][i] = p.s22;
    fields[kS12][i] = p.s12;
    fields[kResiduals][i] = p.residuals;
    fields[kNormal1][i] = p.normal1;
    fields[kNormal2][i] = p.normal2;
    fields[kNormalSquared][i] = p.normal_squared;
  }
};

using BufferTag = hwy::HWY_NAMESPACE::CappedTag<float, SampleBuffer::kPadding>;
using BufferMask = hwy::HWY_NAMESPACE::Mask<BufferTag>;
constexpr int kBufferLanes = static_cast<int>(hwy::HWY_NAMESPACE::MaxLanes(BufferTag()));

/// Eq. 20, candidates against samples; either may be one and the same in all lanes.
struct Agreement {
  using V = hwy::HWY_NAMESPACE::Vec<BufferTag>;
  V mean1, mean2, residuals, normal1, normal2, normal_squared;
  V t1, t2, ray1, ray2, variance;

  HWY_INLINE Agreement() {}  // see Samples
  HWY_INLINE void loadCandidates(const SampleBuffer& b, int i) {
    namespace hn = hwy::HWY_NAMESPACE;
    const BufferTag d;
    mean1 = hn::LoadU(d, b.fields[SampleBuffer::kMean1] + i);
    mean2 = hn::LoadU(d, b.fields[SampleBuffer::kMean2] + i);
    residuals = hn::LoadU(d, b.fields[SampleBuffer::kResiduals] + i);
    normal1 = hn::LoadU(d, b.fields[SampleBuffer::kNormal1] + i);
    normal2 = hn::LoadU(d, b.fields[SampleBuffer::kNormal2] + i);
    normal_squared = hn::LoadU(d, b.fields[SampleBuffer::kNormalSquared] + i);
  }
  HWY_INLINE void setCandidate(const LinePrototypeLane& p) {
    namespace hn = hwy::HWY_NAMESPACE;
    const BufferTag d;
    mean1 = hn::Set(d, p.mean1);
    mean2 = hn::Set(d, p.mean2);
    residuals = hn::Set(d, p.residuals);
    normal1 = hn::Set(d, p.normal1);
    normal2 = hn::Set(d, p.normal2);
    normal_squared = hn::Set(d, p.normal_squared);
  }
  HWY_INLINE void loadSamples(const SampleBuffer& b, int i) {
    namespace hn = hwy::HWY_NAMESPACE;
    const BufferTag d;
    t1 = hn::LoadU(d, b.fields[SampleBuffer::kT1] + i);
    t2 = hn::LoadU(d, b.fields[SampleBuffer::kT2] + i);
    ray1 = hn::LoadU(d, b.fields[SampleBuffer::kRay1] + i);
    ray2 = hn::LoadU(d, b.fields[SampleBuffer::kRay2] + i);
    variance = hn::LoadU(d, b.fields[SampleBuffer::kVariance] + i);
  }
  HWY_INLINE void setSample(const LineSample& s) {
    namespace hn = hwy::HWY_NAMESPACE;
    const BufferTag d;
    t1 = hn::Set(d, s.t1);
    t2 = hn::Set(d, s.t2);
    ray1 = hn::Set(d, s.ray1);
    ray2 = hn::Set(d, s.ray2);
    variance = hn::Set(d, s.variance);
  }
  HWY_INLINE BufferMask holds(const ClusteringRule& rule) const {
    namespace hn = hwy::HWY_NAMESPACE;
    const BufferTag d;
    const V dx = hn::Sub(t1, mean1);
    const V dy = hn::Sub(t2, mean2);
    const V distance = hn::Add(hn::Mul(normal1, dx), hn::Mul(normal2, dy));
    const V projection = hn::Add(hn::Mul(normal1, ray1), hn::Mul(normal2, ray2));
    const V before = hn::Set(d, static_cast<float>(rule.fit_samples - 1));
    const V across =
        larger(hn::Mul(projection, projection), hn::Mul(hn::Set(d, rule.projection_floor), normal_squared));
    const V spread = hn::Add(hn::Mul(residuals, normal_squared), hn::Mul(before, hn::Mul(variance, across)));
    return hn::Le(hn::Mul(hn::Mul(distance, distance), before), hn::Mul(hn::Set(d, rule.k_max_squared), spread));
  }
};

/// Lanes of [i, end) in a vector that starts at i.
HWY_INLINE BufferMask lanesBefore(int i, int end) {
  return hwy::HWY_NAMESPACE::FirstN(BufferTag(), static_cast<std::size_t>(end - i));
}

/// sigma_z^2 and (t1, t2) of `count` depths that stand in place of their variance.
HWY_INLINE void completeDepths(const ScanStrip& strip, const ClusteringRule& rule, int line, int count,
                               SampleBuffer& buffer) {
  namespace hn = hwy::HWY_NAMESPACE;
  const BufferTag d;
  const auto secant = hn::Set(d, strip.secant[line]);
  for (int i = 0; i < count; i += kBufferLanes) {
    const auto z = hn::LoadU(d, buffer.fields[SampleBuffer::kVariance] + i);
    const auto ray2 = hn::LoadU(d, buffer.fields[SampleBuffer::kRay2] + i);
    hn::StoreU(hn::Mul(z, secant), d, buffer.fields[SampleBuffer::kT1] + i);
    hn::StoreU(hn::Mul(z, ray2), d, buffer.fields[SampleBuffer::kT2] + i);
    hn::StoreU(secant, d, buffer.fields[SampleBuffer::kRay1] + i);
    hn::StoreU(varianceOf(d, rule.variance, z), d, buffer.fields[SampleBuffer::kVariance] + i);
  }
}

/// Walks back to the first rejected samples: all that were measured since the last accepted one.
HWY_INLINE void collect(const ScanStrip& strip, const ClusteringRule& rule, int at, int line, SampleBuffer& buffer) {
  const int size = rule.minSamples();
  buffer.begin = buffer.fitted = 0;
  buffer.end = size;
  if (strip.x != nullptr) {
    for (int i = size - 1; i >= 0; --at) {
      float t1, t2;
      readSection(strip, at, line, t1, t2);
      if (isMeasured(t1, t2)) buffer.setSample(i--, readSample(strip, rule, at, line), at);
    }
    return;
  }
  const float* z = strip.z + static_cast<std::size_t>(at) * strip.stride + line;
  for (int i = size - 1; i >= 0; --at, z -= strip.stride) {
    if (!(*z > 0.0f)) continue;
    buffer.fields[SampleBuffer::kVariance][i] = *z;
    buffer.fields[SampleBuffer::kRay2][i] = strip.along[at];
    buffer.counts[SampleBuffer::kRow][i--] = at;
  }
  completeDepths(strip, rule, line, size, buffer);
}

/// Makes room at the end.
HWY_INLINE void moveDown(SampleBuffer& buffer) {
  const int count = buffer.end - buffer.begin;
  for (float* field : buffer.fields)
    for (int i = 0; i < count; ++i) field[i] = field[buffer.begin + i];
  for (std::int32_t* number : buffer.counts)
    for (int i = 0; i < count; ++i) number[i] = number[buffer.begin + i];
  buffer.fitted -= buffer.begin;
  buffer.end = count;
  buffer.begin = 0;
}

/// The new sample counts for the candidates that agree with it. Returns the first that then has enough, or -1.
HWY_INLINE int countForCandidates(const ClusteringRule& rule, const LineSample& sample, SampleBuffer& buffer) {
  namespace hn = hwy::HWY_NAMESPACE;
  const hn::RebindToSigned<BufferTag> di;
  Agreement agreement;
  agreement.setSample(sample);
  int first = -1;
  for (int i = buffer.begin; i < buffer.fitted; i += kBufferLanes) {
    agreement.loadCandidates(buffer, i);
    const auto agrees = hn::RebindMask(di, hn::And(agreement.holds(rule), lanesBefore(i, buffer.fitted)));
    std::int32_t* counts = buffer.counts[SampleBuffer::kAgreeing] + i;
    const auto count = hn::Add(hn::LoadU(di, counts), hn::IfThenElseZero(agrees, hn::Set(di, 1)));
    hn::StoreU(count, di, counts);
    const auto enough = hn::And(agrees, hn::Gt(count, hn::Set(di, rule.validation_samples - 1)));
    if (first < 0 && !hn::AllFalse(di, enough)) first = i + static_cast<int>(hn::FindFirstTrue(di, enough));
  }
  return first;
}

/// Fits the candidate that the newest sample completes, and counts those that agree with it.
HWY_INLINE int fitCandidate(const ClusteringRule& rule, SampleBuffer& buffer) {
  namespace hn = hwy::HWY_NAMESPACE;
  const int start = buffer.fitted++;
  const int fit_end = start + rule.fit_samples;
  LinePrototypeLane p = {1.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f};
  p.mean1 = buffer.fields[SampleBuffer::kT1][start];
  p.mean2 = buffer.fields[SampleBuffer::kT2][start];
  for (int i = start + 1; i < fit_end; ++i) addSample(buffer.sample(i), p);
  finishFit(p);
  buffer.setCandidate(start, p);
  Agreement agreement;
  agreement.setCandidate(p);
  int count = 0;
  for (int i = fit_end; i < buffer.end; i += kBufferLanes) {
    agreement.loadSamples(buffer, i);
    count += static_cast<int>(hn::CountTrue(BufferTag(), hn::And(agreement.holds(rule), lanesBefore(i, buffer.end))));
  }
  buffer.counts[SampleBuffer::kAgreeing][start] = count;
  return count >= rule.validation_samples ? start : -1;
}

/// Puts the sample of a row into the buffer; `waiting` is how many were rejected since the last accepted one, k_min at
/// least. Returns the smallest start whose line enough later samples agree with, or -1. Each candidate is tested once
/// against each sample, which gives what trying every start anew gives.
HWY_INLINE int pushSample(const ScanStrip& strip, const ClusteringRule& rule, int row, int line, int waiting,
                          SampleBuffer& buffer) {
  int start = -1;
  if (waiting == rule.minSamples()) {
    collect(strip, rule, row, line, buffer);
  } else {
    if (buffer.end == buffer.capacity) moveDown(buffer);
    const LineSample sample = readSample(strip, rule, row, line);
    buffer.setSample(buffer.end++, sample, row);
    start = countForCandidates(rule, sample, buffer);
  }
  if (start < 0) start = fitCandidate(rule, buffer);
  if (start < 0 && buffer.end - buffer.begin >= rule.buffer_samples) ++buffer.begin;
  return start;
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace epcc
HWY_AFTER_NAMESPACE();

#endif
