// SPDX-License-Identifier: BSD-3-Clause
// Algorithm 1 of the paper in single precision, a vector lane a scan line, one function a step.
#include "metric/line_clustering.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "metric/line_clustering.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "metric/line_candidates-inl.h"
#include "metric/line_prototypes-inl.h"
#include "metric/line_samples-inl.h"
#include "vector/dispatch.h"

HWY_BEFORE_NAMESPACE();
namespace epcc {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
namespace {

constexpr int kSides = 2;  // two independent vectors: the recurrence waits for its root and its division

/// One row of a side: returns the lanes whose buffer may hold a new segment.
HWY_INLINE MF step(const ClusteringRule& rule, const Samples& s, int row, std::int32_t* numbers, Prototypes& p) {
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

/// Buffers and first samples of the lines, and what leaves them.
struct Lines {
  const ScanStrip& strip;
  const ClusteringRule& rule;
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
HWY_NOINLINE void clusterSides(Lines& lines, int first_line) {
  const ScanStrip strip = lines.strip;  // copies, which no number that is stored can change
  const ClusteringRule rule = lines.rule;
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

void clusterStrip(const ScanStrip& strip, const ClusteringRule& rule, float* memory, int count, StripSegments& result) {
  Lines lines{strip, rule, result, {}, {}};
  for (int line = 0; line < kStripLines; ++line) {
    result.count[line] = 0;
    memory = lines.buffers[line].place(memory, rule);
  }
  for (int line = 0; line < count; line += kSides * kLanes)
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

ClusteringRule::ClusteringRule(const PaperParameters& parameters, const SensorModel& sensor)
    : k_max_squared(static_cast<float>(parameters.line_k_max * parameters.line_k_max)),
      projection_floor(static_cast<float>(parameters.expert.lines.projection_floor)),
      fit_samples(parameters.expert.lines.fit_samples),
      validation_samples(parameters.expert.lines.validation_samples),
      buffer_samples(parameters.expert.lines.buffer_samples) {
  if (parameters.expert.lines.use_sensor_noise) variance = SensorVariance(sensor);
}

void clusterLines(const ScanStrip& strip, const ClusteringRule& rule, LineWorkspace& workspace, StripSegments& result,
                  int lines) {
  float* memory = workspace.floats(kStripLines, HWY_NAMESPACE::SampleBuffer::floats(rule));
  EPCC_KERNEL(clusterStrip)(strip, rule, memory, lines, result);
}

}  // namespace epcc
#endif
