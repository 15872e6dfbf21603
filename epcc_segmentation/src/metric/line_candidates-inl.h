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

#include "metric/line_clustering.h"

HWY_BEFORE_NAMESPACE();
namespace epcc {
namespace HWY_NAMESPACE {
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
HWY_INLINE LineSample readSample(const ScanStrip& strip, const LineRule& rule, int row, int line) {
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

/// Eq. 20.
HWY_INLINE bool agrees(const LineRule& rule, const LinePrototypeLane& p, const LineSample& s) {
  const float dx = s.t1 - p.mean1;
  const float dy = s.t2 - p.mean2;
  const float distance = p.normal1 * dx + p.normal2 * dy;
  const float projection = p.normal1 * s.ray1 + p.normal2 * s.ray2;
  const float before = p.n - 1.0f;
  const float across = maxOf(projection * projection, rule.projection_floor * p.normal_squared);
  const float spread = p.residuals * p.normal_squared + before * (s.variance * across);
  return distance * distance * before <= rule.k_max_squared * spread;
}

/// Rejected samples in order, begin to end, and the candidates that start at each: those up to `fitted` are fitted and
/// have counted every sample so far that agrees with them.
struct SampleBuffer {
  static constexpr int kFields = 17;
  int capacity = 0, begin = 0, end = 0, fitted = 0;
  LineSample* samples = nullptr;
  LinePrototypeLane* candidates = nullptr;
  int* row = nullptr;
  int* agreeing = nullptr;

  static std::size_t floats(const LineRule& rule) {
    return static_cast<std::size_t>(kFields * 2 * rule.buffer_samples);
  }
  float* place(float* memory, const LineRule& rule) {
    capacity = 2 * rule.buffer_samples;
    samples = reinterpret_cast<LineSample*>(memory);
    candidates = reinterpret_cast<LinePrototypeLane*>(memory + 5 * capacity);
    row = reinterpret_cast<int*>(memory + 15 * capacity);
    agreeing = reinterpret_cast<int*>(memory + 16 * capacity);
    return memory + static_cast<std::size_t>(kFields * capacity);
  }
  const LineSample& sample(int i) const { return samples[i]; }
  const LinePrototypeLane& candidate(int start) const { return candidates[start]; }
};

/// Walks back to the first rejected samples: all that were measured since the last accepted one.
HWY_INLINE void collect(const ScanStrip& strip, const LineRule& rule, int at, int line, SampleBuffer& buffer) {
  const int size = rule.minSamples();
  buffer.begin = buffer.fitted = 0;
  buffer.end = size;
  for (int i = size - 1; i >= 0; --at) {
    float t1, t2;
    readSection(strip, at, line, t1, t2);
    if (!isMeasured(t1, t2)) continue;
    buffer.samples[i] = readSample(strip, rule, at, line);
    buffer.row[i--] = at;
  }
}

/// Makes room at the end.
HWY_INLINE void moveDown(SampleBuffer& buffer) {
  const int count = buffer.end - buffer.begin;
  for (int i = 0; i < count; ++i) {
    const int from = buffer.begin + i;
    buffer.samples[i] = buffer.samples[from];
    buffer.row[i] = buffer.row[from];
    buffer.candidates[i] = buffer.candidates[from];
    buffer.agreeing[i] = buffer.agreeing[from];
  }
  buffer.fitted -= buffer.begin;
  buffer.end = count;
  buffer.begin = 0;
}

/// Fits the candidate that the newest sample completes, and counts those that agree with it.
HWY_INLINE void fitCandidate(const LineRule& rule, SampleBuffer& buffer) {
  const int start = buffer.fitted++;
  const int fit_end = start + rule.fit_samples;
  LinePrototypeLane p = {1.0f, buffer.samples[start].t1, buffer.samples[start].t2, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f,
                         0.0f};
  for (int i = start + 1; i < fit_end; ++i) addSample(buffer.samples[i], p);
  finishFit(p);
  int count = 0;
  for (int i = fit_end; i < buffer.end; ++i) count += agrees(rule, p, buffer.samples[i]) ? 1 : 0;
  buffer.candidates[start] = p;
  buffer.agreeing[start] = count;
}

/// Puts the sample of a row into the buffer; `waiting` is how many were rejected since the last accepted one, k_min at
/// least. Returns the smallest start whose line enough later samples agree with, or -1. Each candidate is tested once
/// against each sample, which gives what trying every start anew gives.
HWY_INLINE int pushSample(const ScanStrip& strip, const LineRule& rule, int row, int line, int waiting,
                          SampleBuffer& buffer) {
  if (waiting == rule.minSamples()) {
    collect(strip, rule, row, line, buffer);
  } else {
    if (buffer.end == buffer.capacity) moveDown(buffer);
    const LineSample sample = readSample(strip, rule, row, line);
    buffer.samples[buffer.end] = sample;
    buffer.row[buffer.end++] = row;
    for (int start = buffer.begin; start < buffer.fitted; ++start)
      buffer.agreeing[start] += agrees(rule, buffer.candidates[start], sample) ? 1 : 0;
  }
  fitCandidate(rule, buffer);
  for (int start = buffer.begin; start < buffer.fitted; ++start)
    if (buffer.agreeing[start] >= rule.validation_samples) return start;
  if (buffer.end - buffer.begin >= rule.buffer_samples) ++buffer.begin;
  return -1;
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace epcc
HWY_AFTER_NAMESPACE();

#endif
