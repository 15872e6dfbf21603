// SPDX-License-Identifier: BSD-3-Clause
// S1, sample by sample: accept, buffer, start anew, end at a gap; every lane of a vector is a scan line.
#include "inverse_depth/line_growing.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "inverse_depth/line_growing.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "inverse_depth/line_rule.h"
#include "vector/dispatch.h"

HWY_BEFORE_NAMESPACE();
namespace epcc {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::CappedTag<float, ScanLines::kCount / 2>;
using Ints = hn::RebindToSigned<Floats>;
using Float = hn::Vec<Floats>;
using Int = hn::Vec<Ints>;
using Mask = hn::Mask<Floats>;
constexpr int kLanes = static_cast<int>(hn::MaxLanes(Floats()));

/// The state of Algorithm 1: the active line and what is known of the buffer of rejected samples.
struct LineStates {
  Float weight, mean_x, mean_w, sxx, sxw;
  Int n;
  Int id;   // of the active line, or of the last; -1 before the first
  Int end;  // where the line ends if no sample is accepted before
  Mask active;
  Int buffered;    // rejected samples since the last accepted one or the last gap
  Int buffer_end;  // where they are forgotten
};

HWY_INLINE Int select(Mask mask, Int yes, Int no) {
  return hn::IfThenElse(hn::RebindMask(Ints(), mask), yes, no);
}

HWY_INLINE Mask isGreater(Int a, Int b) {
  return hn::RebindMask(Floats(), hn::Gt(a, b));
}

HWY_INLINE LineStates noLines() {
  const Float zero = hn::Zero(Floats());
  const Int none = hn::Set(Ints(), -1);
  const Int nothing = hn::Zero(Ints());
  return {hn::Set(Floats(), 1.0f), zero,    zero,   zero, zero, nothing, none, nothing,
          hn::Gt(zero, zero),      nothing, nothing};
}

// One sample of each line. It is accepted if (w - mean_w - slope (x - mean_x))^2 <= k^2 sigma_w^2, times
// Sxx^2/sigma_w^2. Then with t = 1/sigma_w^2 and r = t / (W + t), W the weights' sum:
//   Sxx += W r dx^2, Sxw += W r dx dw, mean += r d, W += t.
// Returns the lanes whose buffer of rejected samples may start a line.
HWY_INLINE Mask addSample(LineStates& s, const LineRule& rule, int position, float sample_x, const float* sample_w,
                          const float* sample_weight, float* rejected_weight, std::int32_t* segment) {
  const Floats d;
  const Ints di;
  const Float w = hn::LoadU(d, sample_w);
  const Float t = hn::LoadU(d, sample_weight);
  const Int now = hn::Set(di, position);
  const Int next_end = hn::Set(di, position + rule.reach + 1);
  const Mask valid = hn::Gt(w, hn::Zero(d));
  s.active = hn::And(s.active, isGreater(s.end, now));

  const Float dx = hn::Sub(hn::Set(d, sample_x), s.mean_x);
  const Float dw = hn::Sub(w, s.mean_w);
  const Float residual = hn::Sub(hn::Mul(dw, s.sxx), hn::Mul(dx, s.sxw));
  const Float limit = hn::Mul(hn::Set(d, rule.k2), hn::Mul(s.sxx, s.sxx));
  const Mask fits = hn::Le(hn::Mul(hn::Mul(residual, residual), t), limit);
  const Mask accepted = hn::And(hn::And(s.active, valid), fits);

  const Float sum = hn::Add(s.weight, t);
  const Float ratio = hn::Div(t, sum);  // does not wait for the test
  const Float r = hn::IfThenElseZero(accepted, ratio);
  const Float g = hn::IfThenElseZero(accepted, hn::Mul(s.weight, ratio));
  const Float gx = hn::Mul(g, dx);
  s.weight = hn::IfThenElse(accepted, sum, s.weight);
  s.mean_x = hn::Add(s.mean_x, hn::Mul(r, dx));
  s.mean_w = hn::Add(s.mean_w, hn::Mul(r, dw));
  s.sxx = hn::Add(s.sxx, hn::Mul(gx, dx));
  s.sxw = hn::Add(s.sxw, hn::Mul(gx, dw));
  s.n = select(accepted, hn::Add(s.n, hn::Set(di, 1)), s.n);
  s.end = select(accepted, next_end, s.end);
  hn::StoreU(select(accepted, s.id, hn::Set(di, -1)), di, segment);

  // An accepted sample empties the buffer, and so does a gap.
  const Mask rejected = hn::AndNot(accepted, valid);
  const Mask kept = hn::AndNot(accepted, isGreater(s.buffer_end, now));
  s.buffered = hn::IfThenElseZero(hn::RebindMask(di, kept), s.buffered);
  s.buffered = select(rejected, hn::Add(s.buffered, hn::Set(di, 1)), s.buffered);
  s.buffer_end = select(rejected, next_end, s.buffer_end);
  hn::StoreU(hn::IfThenElseZero(rejected, t), d, rejected_weight);
  return hn::And(rejected, isGreater(s.buffered, hn::Set(di, rule.min_samples - 1)));
}

/// Scan lines whose lanes are in one vector, with the first pixels of their active lines.
struct LaneGroup {
  const ScanLines& in;
  const LineRule& rule;
  float* rejected;  // ring of kCount weights per position
  int lane;         // the first one
  HWY_ALIGN std::int32_t first[kLanes];

  float* rejectedAt(int position) const {
    return rejected + static_cast<std::size_t>(position & rule.ring_mask) * ScanLines::kCount + lane;
  }
  std::size_t at(int position) const {
    return static_cast<std::size_t>(position) * in.pitch + static_cast<std::size_t>(lane);
  }
};

HWY_INLINE unsigned bitsOf(Mask mask) {
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(Floats(), mask, bytes);
  return bytes[0] | (static_cast<unsigned>(bytes[1]) << 8);
}

// Writes the last line of each given lane that has had one.
HWY_INLINE void emitLines(const LaneGroup& group, const LineStates& s, Mask which) {
  const Floats d;
  const Ints di;
  unsigned lanes = bitsOf(hn::And(which, isGreater(s.id, hn::Set(di, -1))));
  if (lanes == 0) return;
  HWY_ALIGN float weight[kLanes], mean_x[kLanes], mean_w[kLanes], sxx[kLanes], sxw[kLanes];
  HWY_ALIGN std::int32_t n[kLanes], id[kLanes], end[kLanes];
  hn::Store(s.weight, d, weight);
  hn::Store(s.mean_x, d, mean_x);
  hn::Store(s.mean_w, d, mean_w);
  hn::Store(s.sxx, d, sxx);
  hn::Store(s.sxw, d, sxw);
  hn::Store(s.n, di, n);
  hn::Store(s.id, di, id);
  hn::Store(s.end, di, end);
  for (; lanes != 0; lanes &= lanes - 1) {
    const auto k = hwy::Num0BitsBelowLS1Bit_Nonzero32(lanes);
    const std::size_t scan_line = static_cast<std::size_t>(group.lane) + k;
    GrownLine& line =
        group.in.lines[scan_line * static_cast<std::size_t>(group.in.capacity) + static_cast<std::size_t>(id[k])];
    line.first = group.first[k];
    line.last = end[k] - group.rule.reach - 1;
    line.n = n[k];
    line.weight = weight[k];
    line.mean_x = mean_x[k];
    line.mean_w = mean_w[k];
    line.sxx = sxx[k];
    line.sxw = sxw[k];
  }
}

// The last min_samples rejected samples start a line of their own if they lie on one: if RSS <= (n - 2) k^2, times Sxx.
HWY_NOINLINE void startLines(LaneGroup& group, int position, Mask full, LineStates& s) {
  const Floats d;
  const Ints di;
  const ScanLines& in = group.in;
  const Float zero = hn::Zero(d);
  const Int none = hn::Zero(di);
  const Float w_now = hn::LoadU(d, in.w + group.at(position));
  const float x_now = in.x[position];
  // Sums about the present sample, backwards until every full lane has its samples.
  Float one = zero, sx = zero, sw = zero, xx = zero, xw = zero, ww = zero;
  Int first = none;
  Int missing = select(full, hn::Set(di, group.rule.min_samples), none);
  int oldest = position;
  for (;; --oldest) {
    const Float weight = hn::LoadU(d, group.rejectedAt(oldest));
    const Mask used = hn::And(hn::Gt(weight, zero), isGreater(missing, none));
    const Float t = hn::IfThenElseZero(used, weight);
    const Float dx = hn::Set(d, in.x[oldest] - x_now);
    const Float dw = hn::Sub(hn::LoadU(d, in.w + group.at(oldest)), w_now);
    const Float tx = hn::Mul(t, dx);
    const Float tw = hn::Mul(t, dw);
    one = hn::Add(one, t);
    sx = hn::Add(sx, tx);
    sw = hn::Add(sw, tw);
    xx = hn::Add(xx, hn::Mul(tx, dx));
    xw = hn::Add(xw, hn::Mul(tx, dw));
    ww = hn::Add(ww, hn::Mul(tw, dw));
    first = select(used, hn::Set(di, oldest), first);
    missing = select(used, hn::Sub(missing, hn::Set(di, 1)), missing);
    if (hn::AllFalse(d, isGreater(missing, none))) break;
  }
  const Float mx = hn::Div(sx, one);
  const Float mw = hn::Div(sw, one);
  const Float sxx = hn::Sub(xx, hn::Mul(sx, mx));
  const Float sxw = hn::Sub(xw, hn::Mul(sx, mw));
  const Float sww = hn::Sub(ww, hn::Mul(sw, mw));
  const Float rss = hn::Sub(hn::Mul(sww, sxx), hn::Mul(sxw, sxw));
  const Mask line = hn::Le(rss, hn::Mul(hn::Set(d, group.rule.max_rss), sxx));
  const Mask spread = hn::Gt(sxx, hn::Mul(hn::Set(d, 1e-12f), one));  // one point over and over is no line
  const Mask started = hn::And(full, hn::And(line, spread));
  if (hn::AllFalse(d, started)) return;

  emitLines(group, s, started);
  const Int one_more = hn::Add(s.id, hn::Set(di, 1));
  s.weight = hn::IfThenElse(started, one, s.weight);
  s.mean_x = hn::IfThenElse(started, hn::Add(hn::Set(d, x_now), mx), s.mean_x);
  s.mean_w = hn::IfThenElse(started, hn::Add(w_now, mw), s.mean_w);
  s.sxx = hn::IfThenElse(started, sxx, s.sxx);
  s.sxw = hn::IfThenElse(started, sxw, s.sxw);
  s.n = select(started, hn::Set(di, group.rule.min_samples), s.n);
  s.id = select(started, one_more, s.id);
  s.end = select(started, hn::Set(di, position + group.rule.reach + 1), s.end);
  s.active = hn::Or(s.active, started);
  s.buffered = select(started, none, s.buffered);
  first = select(started, first, hn::Load(di, group.first));
  hn::Store(first, di, group.first);
  for (int k = position; k >= oldest; --k) {
    std::int32_t* segment = in.segment + group.at(k);
    const Mask in_line = hn::And(hn::Gt(hn::LoadU(d, group.rejectedAt(k)), zero), isGreater(hn::Set(di, k + 1), first));
    hn::StoreU(select(hn::And(started, in_line), s.id, hn::LoadU(di, segment)), di, segment);
  }
}

// Two vectors of scan lines, from their first sample to their last.
HWY_INLINE void growLanes(const ScanLines& in, const LineRule& rule, int lane, float* rejected) {
  LaneGroup group_a{in, rule, rejected, lane, {}};
  LaneGroup group_b{in, rule, rejected, lane + kLanes, {}};
  LineStates a = noLines();
  LineStates b = noLines();
  for (int i = 0; i < in.length; ++i) {
    const std::size_t at_a = group_a.at(i);
    const std::size_t at_b = at_a + kLanes;
    float* rejected_at = group_a.rejectedAt(i);
    const Mask full_a = addSample(a, rule, i, in.x[i], in.w + at_a, in.weight + at_a, rejected_at, in.segment + at_a);
    const Mask full_b =
        addSample(b, rule, i, in.x[i], in.w + at_b, in.weight + at_b, rejected_at + kLanes, in.segment + at_b);
    if (HWY_LIKELY(hn::AllFalse(Floats(), hn::Or(full_a, full_b)))) continue;
    LineStates in_memory = a;  // copies, so that the states themselves stay in registers
    if (!hn::AllFalse(Floats(), full_a)) startLines(group_a, i, full_a, in_memory);
    a = in_memory;
    in_memory = b;
    if (!hn::AllFalse(Floats(), full_b)) startLines(group_b, i, full_b, in_memory);
    b = in_memory;
  }
  const Mask all = hn::Eq(hn::Zero(Floats()), hn::Zero(Floats()));
  const Int one = hn::Set(Ints(), 1);
  emitLines(group_a, a, all);
  emitLines(group_b, b, all);
  hn::StoreU(hn::Add(a.id, one), Ints(), in.line_count + lane);
  hn::StoreU(hn::Add(b.id, one), Ints(), in.line_count + lane + kLanes);
}

void growLines(const ScanLines& in, const LineRule& rule, float* rejected) {
  for (int lane = 0; lane < ScanLines::kCount; lane += 2 * kLanes) growLanes(in, rule, lane, rejected);
}

}  // namespace HWY_NAMESPACE
}  // namespace epcc
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace epcc {

HWY_EXPORT(growLines);

void LineGrowing::grow(const ScanLines& scan_lines) {
  LineRule rule;
  rule.k2 = k_max_ * k_max_;
  rule.max_rss = static_cast<float>(parameters_.min_samples - 2) * rule.k2;
  rule.min_samples = parameters_.min_samples;
  rule.reach = parameters_.max_gap_pixels + 1;
  const int longest = std::min(scan_lines.length, parameters_.min_samples * rule.reach);
  int ring = 1;
  while (ring < longest) ring *= 2;
  rule.ring_mask = ring - 1;
  rejected_.resize(std::max(rejected_.size(), static_cast<std::size_t>(ring) * ScanLines::kCount));
  EPCC_KERNEL(growLines)(scan_lines, rule, rejected_.data());
}

}  // namespace epcc
#endif
