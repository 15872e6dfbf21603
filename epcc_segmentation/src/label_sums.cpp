// SPDX-License-Identifier: BSD-3-Clause
// Finds the stretches of a row that belong to one label and sums each in registers.
#include "label_sums.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "label_sums.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "sensor_variance-inl.h"
#include "vector/dispatch.h"

HWY_BEFORE_NAMESPACE();
namespace epcc {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
namespace {

using Double = hn::CappedTag<double, kSumLanes>;
using Float = hn::Rebind<float, Double>;
using Int = hn::Rebind<std::int32_t, Double>;
using VD = hn::Vec<Double>;
using VF = hn::Vec<Float>;
constexpr std::size_t kLanes = hn::MaxLanes(Double());

/// Whole blocks of a row; `first` to `end` count samples, multiples of kSumLanes.
struct Stretch {
  const SampleRow& row;
  std::size_t first, end;
  std::int32_t label;
};

HWY_INLINE void addTo(VD sum, double* total) {
  const Double d;
  hn::StoreU(hn::Add(hn::LoadU(d, total), sum), d, total);
}

/// Sums 1, x, z, xx, xz, zz along an image row. Its rays share v = y/z, so that y - y0 = v (z - z0) + c there, and the
/// sums with y follow from the others.
struct RowSums {
  VD one, x, z, xx, xz, zz;

  HWY_INLINE RowSums() {}  // that of GCC lacks the vector unit's instructions, which on arm64 is an error
  HWY_INLINE void clear() { one = x = z = xx = xz = zz = hn::Zero(Double()); }
  HWY_INLINE void add(VD weight, VD weight_x, VD weight_z, VD px, VD pz) {
    one = hn::Add(one, weight);
    x = hn::Add(x, weight_x);
    z = hn::Add(z, weight_z);
    xx = hn::Add(xx, hn::Mul(weight_x, px));
    xz = hn::Add(xz, hn::Mul(weight_x, pz));
    zz = hn::Add(zz, hn::Mul(weight_z, pz));
  }
  HWY_INLINE void addToTotals(double along, double offset, double (*totals)[kSumLanes], std::size_t lane) const {
    const Double d;
    const VD v = hn::Set(d, along);
    const VD c = hn::Set(d, offset);
    const VD vz = hn::Mul(v, z);
    const VD c_one = hn::Mul(c, one);
    const VD y = hn::Add(vz, c_one);
    addTo(one, totals[0] + lane);
    addTo(x, totals[1] + lane);
    addTo(y, totals[2] + lane);
    addTo(z, totals[3] + lane);
    addTo(xx, totals[4] + lane);
    addTo(hn::Add(hn::Mul(v, xz), hn::Mul(c, x)), totals[5] + lane);
    addTo(xz, totals[6] + lane);
    // yy = v^2 zz + 2 v c z + c^2
    const VD yz = hn::Add(hn::Mul(v, zz), hn::Mul(c, z));
    addTo(hn::Add(hn::Mul(v, yz), hn::Mul(c, y)), totals[7] + lane);
    addTo(yz, totals[8] + lane);
    addTo(zz, totals[9] + lane);
  }
};

/// Depth of the samples from i on that have the label, else 0.
HWY_INLINE VF depthOfLabel(const Stretch& s, std::size_t i) {
  const Float d;
  const Int di;
  const auto is_label = hn::Eq(hn::LoadU(di, s.row.labels + i), hn::Set(di, s.label));
  return hn::IfThenElseZero(hn::RebindMask(d, is_label), hn::LoadU(d, s.row.z + i));
}

void sumDepths(const Stretch& s, const SensorVariance& variance, LabelSums& sums) {
  const Double d;
  const Float df;
  const VD origin_x = hn::Set(d, sums.origin[0]);
  const VD origin_z = hn::Set(d, sums.origin[2]);
  for (std::size_t lane = 0; lane < kSumLanes; lane += kLanes) {
    RowSums plain, weighted;
    plain.clear();
    weighted.clear();
    for (std::size_t i = s.first + lane; i < s.end; i += kSumLanes) {
      const VF depth = depthOfLabel(s, i);
      const VD z = hn::PromoteTo(d, depth);
      const auto measured = hn::Gt(z, hn::Zero(d));
      const VD weight = hn::PromoteTo(d, hn::Div(hn::Set(df, 1.0f), varianceOf(df, variance, depth)));
      const VD px = hn::IfThenElseZero(measured, hn::Sub(hn::Mul(z, hn::LoadU(d, s.row.across + i)), origin_x));
      const VD pz = hn::IfThenElseZero(measured, hn::Sub(z, origin_z));
      plain.add(hn::IfThenElseZero(measured, hn::Set(d, 1.0)), px, pz, px, pz);
      weighted.add(hn::IfThenElseZero(measured, weight), hn::Mul(weight, px), hn::Mul(weight, pz), px, pz);
    }
    const double offset = s.row.along * sums.origin[2] - sums.origin[1];
    plain.addToTotals(s.row.along, offset, sums.lanes, lane);
    weighted.addToTotals(s.row.along, offset, sums.lanes + kSums, lane);
  }
}

/// Sums of the points, plain or weighted: both at once would not stay in registers.
template <bool kWeighted>
HWY_INLINE void sumPointsOnce(const Stretch& s, const SensorVariance& variance, LabelSums& sums) {
  const Double d;
  const Float df;
  const Int di;
  const VD origin_x = hn::Set(d, sums.origin[0]);
  const VD origin_y = hn::Set(d, sums.origin[1]);
  const VD origin_z = hn::Set(d, sums.origin[2]);
  for (std::size_t lane = 0; lane < kSumLanes; lane += kLanes) {
    const VD zero = hn::Zero(d);
    VD one = zero, x = zero, y = zero, z = zero, xx = zero, xy = zero, xz = zero, yy = zero, yz = zero, zz = zero;
    for (std::size_t i = s.first + lane; i < s.end; i += kSumLanes) {
      const auto is_label = hn::RebindMask(df, hn::Eq(hn::LoadU(di, s.row.labels + i), hn::Set(di, s.label)));
      const VF fx = hn::IfThenElseZero(is_label, hn::LoadU(df, s.row.x + i));
      const VF fy = hn::IfThenElseZero(is_label, hn::LoadU(df, s.row.y + i));
      const VF fz = hn::IfThenElseZero(is_label, hn::LoadU(df, s.row.z + i));
      const VF squared = hn::Add(hn::Add(hn::Mul(fx, fx), hn::Mul(fy, fy)), hn::Mul(fz, fz));
      const VF depth = s.row.depth_is_range ? hn::Sqrt(squared) : hn::Abs(fz);
      const auto measured = hn::Gt(hn::PromoteTo(d, depth), zero);
      const VD weight =
          kWeighted ? hn::PromoteTo(d, hn::Div(hn::Set(df, 1.0f), varianceOf(df, variance, depth))) : hn::Set(d, 1.0);
      const VD px = hn::IfThenElseZero(measured, hn::Sub(hn::PromoteTo(d, fx), origin_x));
      const VD py = hn::IfThenElseZero(measured, hn::Sub(hn::PromoteTo(d, fy), origin_y));
      const VD pz = hn::IfThenElseZero(measured, hn::Sub(hn::PromoteTo(d, fz), origin_z));
      const VD wx = kWeighted ? hn::Mul(weight, px) : px;
      const VD wy = kWeighted ? hn::Mul(weight, py) : py;
      const VD wz = kWeighted ? hn::Mul(weight, pz) : pz;
      one = hn::Add(one, hn::IfThenElseZero(measured, weight));
      x = hn::Add(x, wx);
      y = hn::Add(y, wy);
      z = hn::Add(z, wz);
      xx = hn::Add(xx, hn::Mul(wx, px));
      xy = hn::Add(xy, hn::Mul(wx, py));
      xz = hn::Add(xz, hn::Mul(wx, pz));
      yy = hn::Add(yy, hn::Mul(wy, py));
      yz = hn::Add(yz, hn::Mul(wy, pz));
      zz = hn::Add(zz, hn::Mul(wz, pz));
    }
    const VD all[kSums] = {one, x, y, z, xx, xy, xz, yy, yz, zz};
    for (int k = 0; k < kSums; ++k) addTo(all[k], sums.lanes[k + (kWeighted ? kSums : 0)] + lane);
  }
}

HWY_INLINE void clear(LabelSums& sums) {
  for (auto& lanes : sums.lanes)
    for (double& lane : lanes) lane = 0.0;
}

/// The first point becomes the origin. False if there is none.
HWY_INLINE bool findOrigin(const Stretch& s, LabelSums& sums) {
  const SampleRow& row = s.row;
  for (std::size_t i = s.first; i < s.end && !sums.started; ++i) {
    if (row.labels[i] != s.label) continue;
    const auto z = static_cast<double>(row.z[i]);
    if (row.x != nullptr) {
      sums.started = row.x[i] != 0.0f || row.y[i] != 0.0f || row.z[i] != 0.0f;
      sums.origin[0] = static_cast<double>(row.x[i]);
      sums.origin[1] = static_cast<double>(row.y[i]);
    } else {
      sums.started = z > 0.0;
      sums.origin[0] = z * row.across[i];
      sums.origin[1] = z * row.along;
    }
    sums.origin[2] = z;
  }
  if (sums.started) clear(sums);
  return sums.started;
}

void sumStretch(const Stretch& s, const SensorVariance& variance, LabelSums& sums) {
  if (!sums.started && !findOrigin(s, sums)) return;
  if (s.row.x == nullptr) return sumDepths(s, variance, sums);
  sumPointsOnce<false>(s, variance, sums);
  sumPointsOnce<true>(s, variance, sums);
}

/// What a block has beside one label.
struct Block {
  bool has_label, has_others;
};

HWY_INLINE Block blockOf(const std::int32_t* labels, std::int32_t label) {
  const hn::CappedTag<std::int32_t, kSumLanes> d;
  constexpr std::size_t kStep = hn::MaxLanes(d);
  Block block{false, false};
  for (std::size_t i = 0; i < kSumLanes; i += kStep) {
    const auto l = hn::LoadU(d, labels + i);
    const auto same = hn::Eq(l, hn::Set(d, label));
    block.has_label = block.has_label || !hn::AllFalse(d, same);
    block.has_others = block.has_others || !hn::AllTrue(d, hn::Or(same, hn::Eq(l, hn::Zero(d))));
  }
  return block;
}

/// The labels of a block but 0 and `done`, each once; returns how many.
HWY_INLINE int labelsIn(const std::int32_t* labels, std::int32_t done, std::int32_t (&found)[kSumLanes]) {
  const hn::CappedTag<std::int32_t, kSumLanes> d;
  constexpr std::size_t kStep = hn::MaxLanes(d);
  int count = 0;
  for (std::size_t i = 0; i < kSumLanes; i += kStep) {
    const auto l = hn::LoadU(d, labels + i);
    auto other = hn::Not(hn::Or(hn::Eq(l, hn::Zero(d)), hn::Eq(l, hn::Set(d, done))));
    for (int k = 0; k < count; ++k) other = hn::AndNot(hn::Eq(l, hn::Set(d, found[k])), other);
    while (!hn::AllFalse(d, other)) {
      found[count] = labels[i + static_cast<std::size_t>(hn::FindFirstTrue(d, other))];
      other = hn::AndNot(hn::Eq(l, hn::Set(d, found[count])), other);
      ++count;
    }
  }
  return count;
}

/// Whole blocks. The last label of a block goes on into the blocks that have it alone, and into the next one that has
/// it, too.
bool sumBlocks(const SampleRow& row, const SensorVariance& variance, std::int32_t label_count, LabelSums* sums) {
  bool stray = false;
  const auto sum = [&](std::size_t first, std::size_t end, std::int32_t label) HWY_ATTR {
    if (label < 1 || label > label_count)
      stray = true;
    else
      sumStretch({row, first, end, label}, variance, sums[label - 1]);
  };
  std::int32_t done = 0;  // of the block at `first`, summed with the one before
  for (std::size_t first = 0; first < row.count;) {
    if (done == 0 && !blockOf(row.labels + first, 0).has_others) {
      first += kSumLanes;
      continue;
    }
    std::int32_t found[kSumLanes];
    const int count = labelsIn(row.labels + first, done, found);
    done = 0;
    std::size_t end = first + kSumLanes;
    for (int k = 0; k + 1 < count; ++k) sum(first, end, found[k]);
    if (count == 0) {
      first = end;
      continue;
    }
    const std::int32_t label = found[count - 1];
    Block next{false, false};
    for (; end < row.count; end += kSumLanes) {
      next = blockOf(row.labels + end, label);
      if (next.has_others) break;
    }
    const bool takes_next = end < row.count && next.has_label;
    sum(first, takes_next ? end + kSumLanes : end, label);
    if (takes_next) done = label;
    first = end;
  }
  return stray;
}

bool sumRow(const SampleRow& row, const SensorVariance& variance, std::int32_t label_count, LabelSums* sums) {
  SampleRow whole = row;
  whole.count = row.count / kSumLanes * kSumLanes;
  bool stray = sumBlocks(whole, variance, label_count, sums);
  const std::size_t rest = row.count - whole.count;
  if (rest == 0) return stray;
  std::int32_t labels[kSumLanes] = {};
  float x[kSumLanes] = {}, y[kSumLanes] = {}, z[kSumLanes] = {};
  double across[kSumLanes] = {};
  for (std::size_t i = 0; i < rest; ++i) {
    labels[i] = row.labels[whole.count + i];
    z[i] = row.z[whole.count + i];
    if (row.x == nullptr) {
      across[i] = row.across[whole.count + i];
      continue;
    }
    x[i] = row.x[whole.count + i];
    y[i] = row.y[whole.count + i];
  }
  SampleRow last = row;
  last.count = kSumLanes;
  last.labels = labels;
  last.z = z;
  last.across = across;
  if (row.x != nullptr) {
    last.x = x;
    last.y = y;
  }
  return sumBlocks(last, variance, label_count, sums) || stray;
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
