// SPDX-License-Identifier: BSD-3-Clause
// Algorithm 1 of the paper in single precision, a vector lane a scan line, one function a step.
#include "metric/line_clustering.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "metric/line_clustering.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "metric/line_candidates-inl.h"
#include "sensor_variance-inl.h"
#include "vector/dispatch.h"

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
constexpr int kSides = 2;  // two independent vectors: the recurrence waits for its root and its division

/// A sample of each lane.
struct Samples {
  VF t1, t2, ray1, ray2, variance;
  MF measured;
};

/// The active prototypes. The scatter, n - 1 times the covariance, saves operations: Eq. 13 times n - 1 is
/// S + (n - 1)/n (t - mu)(t - mu)^T, and Eq. 11 likewise.
struct Prototypes {
  VF n, mean1, mean2, s11, s22, s12, residuals;
  VF normal1, normal2, normal_squared;
  VI number, last, waiting;  // segment, row of its last sample, samples rejected since
};

HWY_INLINE MF isMeasured(VF t1, VF t2) {
  const Float d;
  return hn::And(hn::Gt(t1, hn::Zero(d)), hn::Le(hn::Max(t1, hn::Abs(t2)), hn::Set(d, kFarthest)));
}

/// Sections of a depth image: (t1, t2) = z (sqrt(1 + u^2), v).
HWY_INLINE Samples readDepths(const ScanStrip& strip, const LineRule& rule, int row, int line) {
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
HWY_INLINE Samples readPoints(const ScanStrip& strip, const LineRule& rule, int row, int line, VF& sum_x, VF& sum_z) {
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

/// No prototype accepts anything: its residuals are negative.
HWY_INLINE void reset(Prototypes& p) {
  const Float d;
  const VF zero = hn::Zero(d);
  p.n = hn::Set(d, 1.0f);
  p.mean1 = p.mean2 = p.s11 = p.s22 = p.s12 = p.normal1 = p.normal2 = zero;
  p.normal_squared = hn::Set(d, 1.0f);
  p.residuals = hn::Set(d, -1.0f);
  p.number = p.last = p.waiting = hn::Zero(Int());
}

/// Normal by Eq. 15 in its stable form, not normalised.
HWY_INLINE void findNormals(Prototypes& p) {
  const Float d;
  const VF half = hn::Mul(hn::Set(d, 0.5f), hn::Sub(p.s11, p.s22));
  const VF root = hn::Sqrt(hn::Add(hn::Mul(half, half), hn::Mul(p.s12, p.s12)));
  const VF large = hn::Max(hn::Add(hn::Abs(half), root), hn::Set(d, kSmallestNormal));
  const VF small = hn::Neg(p.s12);
  const MF along_t1 = hn::Gt(half, hn::Zero(d));
  p.normal1 = hn::IfThenElse(along_t1, small, large);
  p.normal2 = hn::IfThenElse(along_t1, large, small);
  p.normal_squared = hn::Add(hn::Mul(p.normal1, p.normal1), hn::Mul(p.normal2, p.normal2));
}

/// Eqs. 11 to 13: the prototypes with the sample, whose distance from them is distance / |P|.
HWY_INLINE Prototypes updated(const Prototypes& p, VF dx, VF dy, VF squared_distance) {
  const Float d;
  const VF one = hn::Set(d, 1.0f);
  Prototypes next = p;
  next.n = hn::Add(p.n, one);
  const VF share = hn::Div(one, next.n);
  const VF grown = hn::Mul(p.n, share);
  const VF grown_x = hn::Mul(dx, grown);
  next.residuals = hn::Add(p.residuals, hn::Mul(hn::Div(squared_distance, p.normal_squared), grown));
  next.mean1 = hn::Add(p.mean1, hn::Mul(dx, share));
  next.mean2 = hn::Add(p.mean2, hn::Mul(dy, share));
  next.s11 = hn::Add(p.s11, hn::Mul(grown_x, dx));
  next.s12 = hn::Add(p.s12, hn::Mul(grown_x, dy));
  next.s22 = hn::Add(p.s22, hn::Mul(hn::Mul(dy, grown), dy));
  findNormals(next);
  return next;
}

/// Takes the lanes of `next` that accept.
HWY_INLINE void keepAccepted(MF accepted, const Prototypes& next, Prototypes& p) {
  p.n = hn::IfThenElse(accepted, next.n, p.n);
  p.mean1 = hn::IfThenElse(accepted, next.mean1, p.mean1);
  p.mean2 = hn::IfThenElse(accepted, next.mean2, p.mean2);
  p.s11 = hn::IfThenElse(accepted, next.s11, p.s11);
  p.s22 = hn::IfThenElse(accepted, next.s22, p.s22);
  p.s12 = hn::IfThenElse(accepted, next.s12, p.s12);
  p.residuals = hn::IfThenElse(accepted, next.residuals, p.residuals);
  p.normal1 = hn::IfThenElse(accepted, next.normal1, p.normal1);
  p.normal2 = hn::IfThenElse(accepted, next.normal2, p.normal2);
  p.normal_squared = hn::IfThenElse(accepted, next.normal_squared, p.normal_squared);
}

/// Eq. 20 and, where it holds, the update. The update is worked out for all lanes meanwhile, for its root and its
/// divisions take longer than the decision. Returns the lanes that accept.
HWY_INLINE MF acceptAndUpdate(const LineRule& rule, const Samples& s, Prototypes& p) {
  const Float d;
  const VF dx = hn::Sub(s.t1, p.mean1);
  const VF dy = hn::Sub(s.t2, p.mean2);
  const VF distance = hn::Add(hn::Mul(p.normal1, dx), hn::Mul(p.normal2, dy));
  const VF projection = hn::Add(hn::Mul(p.normal1, s.ray1), hn::Mul(p.normal2, s.ray2));
  const VF squared = hn::Mul(distance, distance);
  const VF before = hn::Sub(p.n, hn::Set(d, 1.0f));
  const VF across =
      hn::Max(hn::Mul(projection, projection), hn::Mul(hn::Set(d, rule.projection_floor), p.normal_squared));
  const VF spread = hn::Add(hn::Mul(p.residuals, p.normal_squared), hn::Mul(before, hn::Mul(s.variance, across)));
  const MF accepted =
      hn::And(s.measured, hn::Le(hn::Mul(squared, before), hn::Mul(hn::Set(d, rule.k_max_squared), spread)));
  keepAccepted(accepted, updated(p, dx, dy, squared), p);
  return accepted;
}

/// One row of a side: returns the lanes whose buffer may hold a new segment.
HWY_INLINE MF step(const LineRule& rule, const Samples& s, int row, std::int32_t* numbers, Prototypes& p) {
  const Int di;
  const MF accepted = acceptAndUpdate(rule, s, p);
  const auto accepted_int = hn::RebindMask(di, accepted);
  hn::StoreU(hn::IfThenElseZero(accepted_int, p.number), di, numbers);
  p.last = hn::IfThenElse(accepted_int, hn::Set(di, row), p.last);
  const MF rejected = hn::AndNot(accepted, s.measured);
  const auto rejected_int = hn::RebindMask(di, rejected);
  p.waiting = hn::IfThenZeroElse(accepted_int, hn::Add(p.waiting, hn::IfThenElseZero(rejected_int, hn::Set(di, 1))));
  const auto full = hn::Gt(p.waiting, hn::Set(di, rule.minSamples() - 1));
  return hn::And(rejected, hn::RebindMask(Float(), full));
}

/// The prototypes in memory, to change one lane.
struct StoredPrototypes {
  HWY_ALIGN float fields[10][kLanes];
  HWY_ALIGN std::int32_t integers[3][kLanes];
};

HWY_INLINE void store(const Prototypes& p, StoredPrototypes& m) {
  const Float d;
  const Int di;
  hn::Store(p.n, d, m.fields[0]);
  hn::Store(p.mean1, d, m.fields[1]);
  hn::Store(p.mean2, d, m.fields[2]);
  hn::Store(p.s11, d, m.fields[3]);
  hn::Store(p.s22, d, m.fields[4]);
  hn::Store(p.s12, d, m.fields[5]);
  hn::Store(p.residuals, d, m.fields[6]);
  hn::Store(p.normal1, d, m.fields[7]);
  hn::Store(p.normal2, d, m.fields[8]);
  hn::Store(p.normal_squared, d, m.fields[9]);
  hn::Store(p.number, di, m.integers[0]);
  hn::Store(p.last, di, m.integers[1]);
  hn::Store(p.waiting, di, m.integers[2]);
}

/// A lane of the prototypes becomes another one; a load of what was just stored in part would have to wait.
HWY_INLINE void setLane(const LinePrototypeLane& lane_prototype, std::int32_t number, std::int32_t last, int lane,
                        Prototypes& p) {
  const Float d;
  const Int di;
  const auto is_lane = hn::Eq(hn::Iota(di, 0), hn::Set(di, lane));
  const MF is_lane_float = hn::RebindMask(d, is_lane);
  const auto set = [&](VF& field, float value)
                       HWY_ATTR { field = hn::IfThenElse(is_lane_float, hn::Set(d, value), field); };
  set(p.n, lane_prototype.n);
  set(p.mean1, lane_prototype.mean1);
  set(p.mean2, lane_prototype.mean2);
  set(p.s11, lane_prototype.s11);
  set(p.s22, lane_prototype.s22);
  set(p.s12, lane_prototype.s12);
  set(p.residuals, lane_prototype.residuals);
  set(p.normal1, lane_prototype.normal1);
  set(p.normal2, lane_prototype.normal2);
  set(p.normal_squared, lane_prototype.normal_squared);
  p.number = hn::IfThenElse(is_lane, hn::Set(di, number), p.number);
  p.last = hn::IfThenElse(is_lane, hn::Set(di, last), p.last);
  p.waiting = hn::IfThenZeroElse(is_lane, p.waiting);
}

/// One lane of the stored prototypes.
HWY_INLINE LinePrototypeLane laneOf(const StoredPrototypes& m, int lane) {
  LinePrototypeLane p;
  p.n = m.fields[0][lane];
  p.mean1 = m.fields[1][lane];
  p.mean2 = m.fields[2][lane];
  p.s11 = m.fields[3][lane];
  p.s22 = m.fields[4][lane];
  p.s12 = m.fields[5][lane];
  p.residuals = m.fields[6][lane];
  p.normal1 = m.fields[7][lane];
  p.normal2 = m.fields[8][lane];
  p.normal_squared = m.fields[9][lane];
  return p;
}

/// Buffers and first samples of the lines, and what leaves them.
struct Lines {
  const ScanStrip& strip;
  const LineRule& rule;
  StripSegments& result;
  SampleBuffer buffers[kStripLines];
  int first[kStripLines];
};

/// The active segment of a line goes out.
void emitSegment(Lines& lines, int line, const LinePrototypeLane& p, int last) {
  StripSegments& result = lines.result;
  LineRecord& record = result.records[line * result.capacity + result.count[line]++];
  const LineSample first_sample = readSample(lines.strip, lines.rule, lines.first[line], line);
  const LineSample last_sample = readSample(lines.strip, lines.rule, last, line);
  record.first = lines.first[line];
  record.last = last;
  record.n = p.n;
  record.mean[0] = p.mean1;
  record.mean[1] = p.mean2;
  record.scatter[0] = p.s11;
  record.scatter[1] = p.s22;
  record.scatter[2] = p.s12;
  record.residuals = p.residuals;
  record.normal[0] = p.normal1;
  record.normal[1] = p.normal2;
  record.first_sample[0] = first_sample.t1;
  record.first_sample[1] = first_sample.t2;
  record.last_sample[0] = last_sample.t1;
  record.last_sample[1] = last_sample.t2;
}

template <class D>
HWY_INLINE std::uint64_t bitsOf(D d, hn::Mask<D> mask) {
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(d, mask, bytes);
  std::uint64_t bits;
  hwy::CopyBytes<8>(bytes, &bits);
  return bits;
}

/// The old segment goes out before the new one takes its samples from the buffer.
HWY_INLINE void startSegment(Lines& lines, int line, int lane, int start, const StoredPrototypes& stored,
                             Prototypes& prototypes) {
  if (stored.integers[0][lane] != 0) emitSegment(lines, line, laneOf(stored, lane), stored.integers[1][lane]);
  const SampleBuffer& buffer = lines.buffers[line];
  StripSegments& result = lines.result;
  const std::int32_t number = result.first_number + result.count[line] * result.number_step + line;
  std::int32_t last = 0;
  const auto take = [&](int i) HWY_ATTR {
    const int row = buffer.counts[SampleBuffer::kRow][i];
    result.numbers[static_cast<std::size_t>(row) * result.number_stride + line] = number;
    last = row;
  };
  const int fit_end = start + lines.rule.fit_samples;
  LinePrototypeLane p = buffer.candidate(start, lines.rule);
  Agreement agreement;
  agreement.setCandidate(p);
  for (int i = start; i < fit_end; ++i) take(i);
  for (int i = fit_end; i < buffer.end; i += kBufferLanes) {
    agreement.loadSamples(buffer, i);
    const BufferMask agrees = hn::And(agreement.holds(lines.rule), lanesBefore(i, buffer.end));
    for (std::uint64_t bits = bitsOf(BufferTag(), agrees); bits != 0; bits &= bits - 1) {
      const int at = i + static_cast<int>(hwy::Num0BitsBelowLS1Bit_Nonzero64(bits));
      addSample(buffer.sample(at), p);
      take(at);
    }
  }
  finishFit(p);
  lines.first[line] = buffer.counts[SampleBuffer::kRow][start];
  setLane(p, number, last, lane, prototypes);
}

/// Looks for new segments in the lanes of a mask.
HWY_NOINLINE void findSegments(Lines& lines, int first_line, int row, std::uint64_t lanes, Prototypes& p) {
  StoredPrototypes stored;
  hn::Store(p.waiting, Int(), stored.integers[2]);
  bool is_stored = false;
  for (; lanes != 0; lanes &= lanes - 1) {
    const int lane = static_cast<int>(hwy::Num0BitsBelowLS1Bit_Nonzero64(lanes));
    const int line = first_line + lane;
    const int start = pushSample(lines.strip, lines.rule, row, line, stored.integers[2][lane], lines.buffers[line]);
    if (start < 0) continue;
    if (!is_stored) store(p, stored);
    is_stored = true;
    startSegment(lines, line, lane, start, stored, p);
  }
}

/// Two vectors of lines, from the first row to the last.
template <bool kPoints>
void clusterSides(Lines& lines, int first_line) {
  const ScanStrip strip = lines.strip;  // copies, which no number that is stored can change
  const LineRule rule = lines.rule;
  StripSegments& result = lines.result;
  std::int32_t* const all_numbers = result.numbers + first_line;
  const std::size_t number_stride = result.number_stride;
  const Float d;
  Prototypes p0, p1;
  reset(p0);
  reset(p1);
  VF x0 = hn::Zero(d), z0 = x0, x1 = x0, z1 = x0;
  const int second_line = first_line + kLanes;
  for (int row = 0; row < strip.height; ++row) {
    std::int32_t* numbers = all_numbers + static_cast<std::size_t>(row) * number_stride;
    const Samples s0 =
        kPoints ? readPoints(strip, rule, row, first_line, x0, z0) : readDepths(strip, rule, row, first_line);
    const Samples s1 =
        kPoints ? readPoints(strip, rule, row, second_line, x1, z1) : readDepths(strip, rule, row, second_line);
    const MF full0 = step(rule, s0, row, numbers, p0);
    const MF full1 = step(rule, s1, row, numbers + kLanes, p1);
    if (HWY_LIKELY(hn::AllFalse(d, hn::Or(full0, full1)))) continue;
    if (!hn::AllFalse(d, full0)) findSegments(lines, first_line, row, bitsOf(d, full0), p0);
    if (!hn::AllFalse(d, full1)) findSegments(lines, second_line, row, bitsOf(d, full1), p1);
  }
  const auto finish = [&](const Prototypes& p, VF x, VF z, int line) HWY_ATTR {
    StoredPrototypes stored;
    store(p, stored);
    HWY_ALIGN float sums[2][kLanes];
    hn::Store(x, d, sums[0]);
    hn::Store(z, d, sums[1]);
    for (int lane = 0; lane < kLanes; ++lane) {
      result.direction[line + lane][0] = sums[0][lane];
      result.direction[line + lane][1] = sums[1][lane];
      if (stored.integers[0][lane] != 0)
        emitSegment(lines, line + lane, laneOf(stored, lane), stored.integers[1][lane]);
    }
  };
  finish(p0, x0, z0, first_line);
  finish(p1, x1, z1, second_line);
}

void clusterStrip(const ScanStrip& strip, const LineRule& rule, float* memory, StripSegments& result) {
  Lines lines{strip, rule, result, {}, {}};
  for (int line = 0; line < kStripLines; ++line) {
    result.count[line] = 0;
    memory = lines.buffers[line].place(memory, rule);
  }
  for (int line = 0; line < kStripLines; line += kSides * kLanes)
    if (strip.x != nullptr)
      clusterSides<true>(lines, line);
    else
      clusterSides<false>(lines, line);
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace epcc
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace epcc {

namespace {
HWY_EXPORT(clusterStrip);
}  // namespace

LineRule::LineRule(const PaperParameters& parameters, const SensorModel& sensor)
    : k_max_squared(static_cast<float>(parameters.line_k_max * parameters.line_k_max)),
      projection_floor(static_cast<float>(parameters.expert.lines.projection_floor)),
      fit_samples(parameters.expert.lines.fit_samples),
      validation_samples(parameters.expert.lines.validation_samples),
      buffer_samples(parameters.expert.lines.buffer_samples) {
  if (parameters.expert.lines.use_sensor_noise) variance = SensorVariance(sensor);
}

void clusterLines(const ScanStrip& strip, const LineRule& rule, LineWorkspace& workspace, StripSegments& result) {
  float* memory = workspace.floats(kStripLines, HWY_NAMESPACE::SampleBuffer::floats(rule));
  EPCC_KERNEL(clusterStrip)(strip, rule, memory, result);
}

}  // namespace epcc
#endif
