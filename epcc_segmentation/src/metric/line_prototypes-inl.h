// SPDX-License-Identifier: BSD-3-Clause
// Linear prototypes of neighbouring scan lines and their recursion; part of the kernel of Algorithm 1.
#if defined(EPCC_METRIC_LINE_PROTOTYPES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef EPCC_METRIC_LINE_PROTOTYPES_INL_H_
#undef EPCC_METRIC_LINE_PROTOTYPES_INL_H_
#else
#define EPCC_METRIC_LINE_PROTOTYPES_INL_H_
#endif

#include <hwy/highway.h>

#include "metric/line_candidates-inl.h"
#include "metric/line_samples-inl.h"
#include "vector/extremes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace epcc {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
namespace {

/// The active prototypes. The scatter, n - 1 times the covariance, saves operations: Eq. 13 times n - 1 is
/// S + (n - 1)/n (t - mu)(t - mu)^T, and Eq. 11 likewise.
struct Prototypes {
  VF n, mean1, mean2, s11, s22, s12, residuals;
  VF normal1, normal2, normal_squared;
  VI number, last, waiting;  // segment, row of its last sample, samples rejected since

  HWY_INLINE Prototypes() {}  // see Samples
};

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
  const VF large = larger(hn::Add(hn::Abs(half), root), hn::Set(d, kSmallestNormal));
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
HWY_INLINE MF acceptAndUpdate(const ClusteringRule& rule, const Samples& s, Prototypes& p) {
  const Float d;
  const VF dx = hn::Sub(s.t1, p.mean1);
  const VF dy = hn::Sub(s.t2, p.mean2);
  const VF distance = hn::Add(hn::Mul(p.normal1, dx), hn::Mul(p.normal2, dy));
  const VF projection = hn::Add(hn::Mul(p.normal1, s.ray1), hn::Mul(p.normal2, s.ray2));
  const VF squared = hn::Mul(distance, distance);
  const VF before = hn::Sub(p.n, hn::Set(d, 1.0f));
  const VF across =
      larger(hn::Mul(projection, projection), hn::Mul(hn::Set(d, rule.projection_floor), p.normal_squared));
  const VF spread = hn::Add(hn::Mul(p.residuals, p.normal_squared), hn::Mul(before, hn::Mul(s.variance, across)));
  const MF accepted =
      hn::And(s.measured, hn::Le(hn::Mul(squared, before), hn::Mul(hn::Set(d, rule.k_max_squared), spread)));
  keepAccepted(accepted, updated(p, dx, dy, squared), p);
  return accepted;
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

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace epcc
HWY_AFTER_NAMESPACE();

#endif
