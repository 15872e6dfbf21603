// SPDX-License-Identifier: BSD-3-Clause
// Runs of equal labels, four pixels at a time on every vector unit, so that the order of the sums is one.
#include "inverse_depth/row_sums.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "inverse_depth/row_sums.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "vector/dispatch.h"

HWY_BEFORE_NAMESPACE();
namespace epcc {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

constexpr int kStep = 4;
using Doubles = hn::CappedTag<double, kStep>;
using Floats = hn::Rebind<float, Doubles>;
using Double = hn::Vec<Doubles>;
constexpr int kLanes = static_cast<int>(hn::MaxLanes(Doubles()));
constexpr int kVectors = kStep / kLanes;

/// Sums along a run.
enum { kPlain, kOne, kA, kAA, kW, kAW, kWW, kPerspective, kF = kPerspective, kAF, kFW, kSpherical };

/// Those of each place among four pixels.
template <bool spherical>
struct RunSums {
  static constexpr int kCount = spherical ? kSpherical : kPerspective;
  Double sum[kCount][kVectors];

  HWY_INLINE RunSums() {
    for (auto& vectors : sum)
      for (Double& vector : vectors) vector = hn::Zero(Doubles());
  }
  /// Of four pixels the first `count`.
  template <bool all>
  HWY_INLINE void add(const LabelledRow& row, int column, int count) {
    const Doubles d;
    for (int k = 0; k < kVectors; ++k, column += kLanes, count -= kLanes) {
      Double t = hn::PromoteTo(d, hn::LoadU(Floats(), row.weight + column));
      Double w = hn::PromoteTo(d, hn::LoadU(Floats(), row.w + column));
      if (!all) {
        const auto counts = hn::FirstN(d, static_cast<std::size_t>(count > 0 ? count : 0));
        t = hn::IfThenElseZero(counts, t);
        w = hn::IfThenElseZero(counts, w);
      }
      const Double a = hn::LoadU(d, row.across + column);
      const Double ta = hn::Mul(t, a);
      const Double tw = hn::Mul(t, w);
      sum[kPlain][k] = hn::Add(sum[kPlain][k], w);
      sum[kOne][k] = hn::Add(sum[kOne][k], t);
      sum[kA][k] = hn::Add(sum[kA][k], ta);
      sum[kAA][k] = hn::Add(sum[kAA][k], hn::Mul(ta, a));
      sum[kW][k] = hn::Add(sum[kW][k], tw);
      sum[kAW][k] = hn::Add(sum[kAW][k], hn::Mul(tw, a));
      sum[kWW][k] = hn::Add(sum[kWW][k], hn::Mul(tw, w));
      if constexpr (spherical) {
        const Double f = hn::LoadU(d, row.forward + column);
        sum[kF][k] = hn::Add(sum[kF][k], hn::Mul(t, f));
        sum[kAF][k] = hn::Add(sum[kAF][k], hn::Mul(ta, f));
        sum[kFW][k] = hn::Add(sum[kFW][k], hn::Mul(tw, f));
      }
    }
  }
  HWY_INLINE void total(double* result) const {
    for (int i = 0; i < kCount; ++i) {
      HWY_ALIGN double lanes[kStep];
      for (int k = 0; k < kVectors; ++k) hn::Store(sum[i][k], Doubles(), lanes + k * kLanes);
      result[i] = (lanes[0] + lanes[1]) + (lanes[2] + lanes[3]);
    }
  }
};

template <bool spherical>
HWY_INLINE void addPixel(const LabelledRow& row, int column, double* sum) {
  const auto t = static_cast<double>(row.weight[column]);
  const auto w = static_cast<double>(row.w[column]);
  const double a = row.across[column];
  const double ta = t * a;
  const double tw = t * w;
  sum[kPlain] += w;
  sum[kOne] += t;
  sum[kA] += ta;
  sum[kAA] += ta * a;
  sum[kW] += tw;
  sum[kAW] += tw * a;
  sum[kWW] += tw * w;
  if constexpr (spherical) {
    const double f = row.forward[column];
    sum[kF] += t * f;
    sum[kAF] += ta * f;
    sum[kFW] += tw * f;
  }
}

template <bool spherical>
HWY_INLINE void addRun(const double* run, double n, double v, RaySums& sums) {
  const double f = run[spherical ? kF : kOne];
  sums.n += n;
  sums.w_plain += run[kPlain];
  sums.one += run[kOne];
  sums.aa += run[kAA];
  sums.af += run[spherical ? kAF : kA];
  sums.av += v * run[kA];
  sums.fv += v * f;
  sums.vv += v * v * run[kOne];
  sums.aw += run[kAW];
  sums.vw += v * run[kW];
  sums.fw += run[spherical ? kFW : kW];
  sums.ww += run[kWW];
}

/// How many of four labels are `label` before there is another.
HWY_INLINE int alike(const std::int32_t* labels, std::int32_t label) {
  const int a = labels[0] == label ? 1 : 0, b = labels[1] == label ? a : 0, c = labels[2] == label ? b : 0;
  return a + b + c + (labels[3] == label ? c : 0);
}

// Where a run ends cannot be foreseen: its last pixels are taken together, none or three.
template <bool spherical>
HWY_INLINE void addRuns(const LabelledRow& row, RaySums* sums) {
  int column = 0;
  while (column < row.width) {
    const std::int32_t label = row.label[column];
    if (label == 0) {
      ++column;
      continue;
    }
    const int first = column;
    RunSums<spherical> lanes;
    int last = kStep;
    for (; column + kStep <= row.width && last == kStep; column += last) {
      last = alike(row.label + column, label);
      if (last == kStep)
        lanes.template add<true>(row, column, kStep);
      else
        lanes.template add<false>(row, column, last);
    }
    double run[RunSums<spherical>::kCount];
    lanes.total(run);
    if (last == kStep)
      for (; column < row.width && row.label[column] == label; ++column) addPixel<spherical>(row, column, run);
    addRun<spherical>(run, column - first, row.along, sums[label - 1]);
  }
}

void addLabelledRow(const LabelledRow& row, RaySums* sums) {
  if (row.forward != nullptr)
    addRuns<true>(row, sums);
  else
    addRuns<false>(row, sums);
}

}  // namespace HWY_NAMESPACE
}  // namespace epcc
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace epcc {

HWY_EXPORT(addLabelledRow);

void addRow(const LabelledRow& row, RaySums* sums) {
  EPCC_KERNEL(addLabelledRow)(row, sums);
}

}  // namespace epcc
#endif
