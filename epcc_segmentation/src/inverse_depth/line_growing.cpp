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
  Int id;          // of the active line, or of the last; -1 before the first
  Int end;         // where the line ends if no sample is accepted before: it is active up to there
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
  return {hn::Set(Floats(), 1.0f), zero, zero, zero, zero, nothing, none, nothing, nothing, nothing};
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
  const Mask active = isGreater(s.end, now);

  const Float dx = hn::Sub(hn::Set(d, sample_x), s.mean_x);
  const Float dw = hn::Sub(w, s.mean_w);
  const Float residual = hn::Sub(hn::Mul(dw, s.sxx), hn::Mul(dx, s.sxw));
  const Float limit = hn::Mul(hn::Set(d, rule.k2), hn::Mul(s.sxx, s.sxx));
  const Mask fits = hn::Le(hn::Mul(hn::Mul(residual, residual), t), limit);
  const Mask accepted = hn::And(hn::And(active, valid), fits);

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

/// Scan lines whose lanes are in one vector. The states are here while lines start and end.
struct LaneGroup {
  ScanLines in;
  LineRule rule;
  float* rejected;  // ring of kCount weights per position
  int lane;         // the first one
  HWY_ALIGN float weight[kLanes], mean_x[kLanes], mean_w[kLanes], sxx[kLanes], sxw[kLanes];
  HWY_ALIGN std::int32_t n[kLanes], id[kLanes], end[kLanes], buffered[kLanes];
  HWY_ALIGN std::int32_t first[kLanes];  // pixels of the active lines

  float* rejectedAt(int position) const {
    return rejected + static_cast<std::size_t>(position & rule.ring_mask) * ScanLines::kCount + lane;
  }
  std::size_t at(int position) const {
    return static_cast<std::size_t>(position) * in.pitch + static_cast<std::size_t>(lane);
  }
};

HWY_INLINE void save(const LineStates& s, LaneGroup& group) {
  const Floats d;
  const Ints di;
  hn::Store(s.weight, d, group.weight);
  hn::Store(s.mean_x, d, group.mean_x);
  hn::Store(s.mean_w, d, group.mean_w);
  hn::Store(s.sxx, d, group.sxx);
  hn::Store(s.sxw, d, group.sxw);
  hn::Store(s.n, di, group.n);
  hn::Store(s.id, di, group.id);
  hn::Store(s.end, di, group.end);
  hn::Store(s.buffered, di, group.buffered);
}

HWY_INLINE void load(const LaneGroup& group, LineStates& s) {
  const Floats d;
  const Ints di;
  s.weight = hn::Load(d, group.weight);
  s.mean_x = hn::Load(d, group.mean_x);
  s.mean_w = hn::Load(d, group.mean_w);
  s.sxx = hn::Load(d, group.sxx);
  s.sxw = hn::Load(d, group.sxw);
  s.n = hn::Load(di, group.n);
  s.id = hn::Load(di, group.id);
  s.end = hn::Load(di, group.end);
  s.buffered = hn::Load(di, group.buffered);
}

HWY_INLINE void replace(Mask mask, Float value, float* values) {
  hn::Store(hn::IfThenElse(mask, value, hn::Load(Floats(), values)), Floats(), values);
}

HWY_INLINE void replace(Mask mask, Int value, std::int32_t* values) {
  hn::Store(select(mask, value, hn::Load(Ints(), values)), Ints(), values);
}

// Writes the last line of each given lane that has had one.
HWY_INLINE void emitLines(const LaneGroup& group, Mask which) {
  const Ints di;
  const Mask any_yet = isGreater(hn::Load(di, group.id), hn::Set(di, -1));
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(Floats(), hn::And(which, any_yet), bytes);
  GrownLine* lines =
      group.in.lines + static_cast<std::size_t>(group.lane) * static_cast<std::size_t>(group.in.capacity);
  for (unsigned lanes = bytes[0] | (static_cast<unsigned>(bytes[1]) << 8); lanes != 0; lanes &= lanes - 1) {
    const auto k = hwy::Num0BitsBelowLS1Bit_Nonzero32(lanes);
    GrownLine& line = lines[k * static_cast<std::size_t>(group.in.capacity) + static_cast<std::size_t>(group.id[k])];
    line.first = group.first[k];
    line.last = group.end[k] - group.rule.reach - 1;
    line.n = group.n[k];
    line.weight = group.weight[k];
    line.mean_x = group.mean_x[k];
    line.mean_w = group.mean_w[k];
    line.sxx = group.sxx[k];
    line.sxw = group.sxw[k];
  }
}

// The last min_samples rejected samples start a line of their own if they lie on one: if RSS <= (n - 2) k^2, times Sxx.
HWY_NOINLINE void startLines(int position, Mask full, LaneGroup& group) {
  const Floats d;
  const Ints di;
  const ScanLines in = group.in;
  const LineRule rule = group.rule;
  const Float zero = hn::Zero(d);
  const Int none = hn::Zero(di);
  const Float w_now = hn::LoadU(d, in.w + group.at(position));
  const float x_now = in.x[position];
  // Sums about the present sample, backwards until every full lane has its samples: seldom further than those of its
  // number that came last.
  Float one = zero, sx = zero, sw = zero, xx = zero, xw = zero, ww = zero;
  Int first = none;
  Int missing = select(full, hn::Set(di, rule.min_samples), none);
  int oldest = position + 1;
  do {
    const int samples = oldest > position ? rule.min_samples : 1;
    for (int k = 0; k < samples; ++k) {
      --oldest;
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
    }
  } while (!hn::AllFalse(d, isGreater(missing, none)));
  const Float mx = hn::Div(sx, one);
  const Float mw = hn::Div(sw, one);
  const Float sxx = hn::Sub(xx, hn::Mul(sx, mx));
  const Float sxw = hn::Sub(xw, hn::Mul(sx, mw));
  const Float sww = hn::Sub(ww, hn::Mul(sw, mw));
  const Float rss = hn::Sub(hn::Mul(sww, sxx), hn::Mul(sxw, sxw));
  const Mask line = hn::Le(rss, hn::Mul(hn::Set(d, rule.max_rss), sxx));
  const Mask spread = hn::Gt(sxx, hn::Mul(hn::Set(d, 1e-12f), one));  // one point over and over is no line
  const Mask started = hn::And(full, hn::And(line, spread));
  if (hn::AllFalse(d, started)) return;

  emitLines(group, started);
  const Int id = hn::Add(hn::Load(di, group.id), hn::Set(di, 1));
  replace(started, one, group.weight);
  replace(started, hn::Add(hn::Set(d, x_now), mx), group.mean_x);
  replace(started, hn::Add(w_now, mw), group.mean_w);
  replace(started, sxx, group.sxx);
  replace(started, sxw, group.sxw);
  replace(started, hn::Set(di, rule.min_samples), group.n);
  replace(started, id, group.id);
  replace(started, hn::Set(di, position + rule.reach + 1), group.end);
  replace(started, none, group.buffered);
  replace(started, first, group.first);
  for (int k = position; k >= oldest; --k) {
    std::int32_t* segment = in.segment + group.at(k);
    const Mask later = isGreater(hn::Set(di, k + 1), first);
    const Mask used = hn::And(later, hn::Gt(hn::LoadU(d, group.rejectedAt(k)), zero));
    hn::StoreU(select(hn::And(started, used), id, hn::LoadU(di, segment)), di, segment);
  }
}

// Two vectors of scan lines, from their first sample to their last.
HWY_INLINE void growLanes(const ScanLines& all, const LineRule& the_rule, int lane, float* rejected) {
  const ScanLines in = all;  // copies that no result can change
  const LineRule rule = the_rule;
  LaneGroup group_a{}, group_b{};
  group_a.in = group_b.in = in;
  group_a.rule = group_b.rule = rule;
  group_a.rejected = group_b.rejected = rejected;
  group_a.lane = lane;
  group_b.lane = lane + kLanes;
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
    if (!hn::AllFalse(Floats(), full_a)) {
      save(a, group_a);
      startLines(i, full_a, group_a);
      load(group_a, a);
    }
    if (!hn::AllFalse(Floats(), full_b)) {
      save(b, group_b);
      startLines(i, full_b, group_b);
      load(group_b, b);
    }
  }
  const Mask every = hn::Eq(hn::Zero(Floats()), hn::Zero(Floats()));
  const Int one = hn::Set(Ints(), 1);
  save(a, group_a);
  save(b, group_b);
  emitLines(group_a, every);
  emitLines(group_b, every);
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

int LineGrowing::ringFor(int length) const {
  const int longest = std::min(length, parameters_.min_samples * (parameters_.max_gap_pixels + 1));
  int ring = 1;
  while (ring < longest) ring *= 2;
  return ring;
}

void LineGrowing::makeRoom(int length) {
  rejected_.resize(std::max(rejected_.size(), static_cast<std::size_t>(ringFor(length))));
}

void LineGrowing::grow(const ScanLines& scan_lines) {
  LineRule rule;
  rule.k2 = k_max_ * k_max_;
  rule.max_rss = static_cast<float>(parameters_.min_samples - 2) * rule.k2;
  rule.min_samples = parameters_.min_samples;
  rule.reach = parameters_.max_gap_pixels + 1;
  rule.ring_mask = ringFor(scan_lines.length) - 1;
  makeRoom(scan_lines.length);
  EPCC_KERNEL(growLines)(scan_lines, rule, rejected_.front().values);
}

}  // namespace epcc
#endif
