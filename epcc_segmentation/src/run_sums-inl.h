// SPDX-License-Identifier: BSD-3-Clause
// Sums over the samples of a run of one label, in lanes; part of kernels, compiled for each vector unit.
#if defined(EPCC_RUN_SUMS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef EPCC_RUN_SUMS_INL_H_
#undef EPCC_RUN_SUMS_INL_H_
#else
#define EPCC_RUN_SUMS_INL_H_
#endif

#include <hwy/highway.h>

#include <cstddef>

#include "label_sums.h"

HWY_BEFORE_NAMESPACE();
namespace epcc {
namespace HWY_NAMESPACE {
namespace {

/// Of a run of depths: 1, x, z, xx, xz, zz, then the same with weights.
constexpr int kRaySums = 6;

/// Samples of one label, all of them measured unless the sums tell. What lies up to a block beyond them may be read.
struct Run {
  std::size_t count;
  const float* weight;
  const float* x;  // of a cloud
  const float* y;
  const float* z;
  const double* across;  // of a depth image
};

#if HWY_TARGET == HWY_EMU128  // the compiler makes vectors of plain loops over the lanes, but not of emulated masks

template <bool kWeighted>
HWY_INLINE void addRays(const Run& run, std::size_t first, int lanes, const double* origin, double (*sums)[kRunLanes]) {
  for (int k = 0; k < lanes; ++k) {
    const std::size_t i = first + static_cast<std::size_t>(k);
    const auto z = static_cast<double>(run.z[i]);
    const double px = z * run.across[i] - origin[0];
    const double pz = z - origin[2];
    sums[0][k] += 1.0;
    sums[1][k] += px;
    sums[2][k] += pz;
    sums[3][k] += px * px;
    sums[4][k] += px * pz;
    sums[5][k] += pz * pz;
    if (!kWeighted) continue;
    const auto weight = static_cast<double>(run.weight[i]);
    const double wx = weight * px, wz = weight * pz;
    sums[6][k] += weight;
    sums[7][k] += wx;
    sums[8][k] += wz;
    sums[9][k] += wx * px;
    sums[10][k] += wx * pz;
    sums[11][k] += wz * pz;
  }
}

template <bool kWeighted>
HWY_INLINE void addPoints(const Run& run, std::size_t first, int lanes, const double* origin,
                          double (*sums)[kRunLanes]) {
  for (int k = 0; k < lanes; ++k) {
    const std::size_t i = first + static_cast<std::size_t>(k);
    const double px = static_cast<double>(run.x[i]) - origin[0];
    const double py = static_cast<double>(run.y[i]) - origin[1];
    const double pz = static_cast<double>(run.z[i]) - origin[2];
    sums[0][k] += 1.0;
    sums[1][k] += px;
    sums[2][k] += py;
    sums[3][k] += pz;
    sums[4][k] += px * px;
    sums[5][k] += px * py;
    sums[6][k] += px * pz;
    sums[7][k] += py * py;
    sums[8][k] += py * pz;
    sums[9][k] += pz * pz;
    if (!kWeighted) continue;
    const auto weight = static_cast<double>(run.weight[i]);
    const double wx = weight * px, wy = weight * py, wz = weight * pz;
    sums[10][k] += weight;
    sums[11][k] += wx;
    sums[12][k] += wy;
    sums[13][k] += wz;
    sums[14][k] += wx * px;
    sums[15][k] += wx * py;
    sums[16][k] += wx * pz;
    sums[17][k] += wy * py;
    sums[18][k] += wy * pz;
    sums[19][k] += wz * pz;
  }
}

template <bool kWeighted>
HWY_INLINE void sumRays(const Run& run, const double* origin, double (*sums)[kRunLanes]) {
  for (int i = 0; i < 2 * kRaySums; ++i)
    for (int k = 0; k < kRunLanes; ++k) sums[i][k] = 0.0;
  std::size_t i = 0;
  for (; i + kRunLanes <= run.count; i += kRunLanes) addRays<kWeighted>(run, i, kRunLanes, origin, sums);
  addRays<kWeighted>(run, i, static_cast<int>(run.count - i), origin, sums);
}

template <bool kWeighted>
HWY_INLINE void sumPoints(const Run& run, const double* origin, double (*sums)[kRunLanes]) {
  for (int i = 0; i < 2 * kSums; ++i)
    for (int k = 0; k < kRunLanes; ++k) sums[i][k] = 0.0;
  std::size_t i = 0;
  for (; i + kRunLanes <= run.count; i += kRunLanes) addPoints<kWeighted>(run, i, kRunLanes, origin, sums);
  addPoints<kWeighted>(run, i, static_cast<int>(run.count - i), origin, sums);
}

#else

using Double = hwy::HWY_NAMESPACE::CappedTag<double, kRunLanes>;
using DoubleVector = hwy::HWY_NAMESPACE::Vec<Double>;
constexpr std::size_t kLanes = hwy::HWY_NAMESPACE::MaxLanes(Double());

HWY_INLINE DoubleVector loadFloats(const float* values) {
  namespace hn = hwy::HWY_NAMESPACE;
  return hn::PromoteTo(Double(), hn::LoadU(hn::Rebind<float, Double>(), values));
}

/// Lanes of the last block from `lane` on that belong to the run, as a mask.
HWY_INLINE hwy::HWY_NAMESPACE::Mask<Double> lanesBelow(std::size_t lanes, std::size_t lane) {
  return hwy::HWY_NAMESPACE::FirstN(Double(), lanes > lane ? lanes - lane : 0);
}

/// How many samples of a run are in each lane.
HWY_INLINE void countLanes(std::size_t count, double* lanes) {
  for (std::size_t k = 0; k < kRunLanes; ++k) lanes[k] = static_cast<double>((count + kRunLanes - 1 - k) / kRunLanes);
}

/// x, z, xx, xz, zz.
struct RaySums {
  DoubleVector x, z, xx, xz, zz;

  HWY_INLINE RaySums() { x = z = xx = xz = zz = hwy::HWY_NAMESPACE::Zero(Double()); }
  HWY_INLINE void add(DoubleVector weight_x, DoubleVector weight_z, DoubleVector px, DoubleVector pz) {
    namespace hn = hwy::HWY_NAMESPACE;
    x = hn::Add(x, weight_x);
    z = hn::Add(z, weight_z);
    xx = hn::Add(xx, hn::Mul(weight_x, px));
    xz = hn::Add(xz, hn::Mul(weight_x, pz));
    zz = hn::Add(zz, hn::Mul(weight_z, pz));
  }
  HWY_INLINE void store(double (*sums)[kRunLanes], std::size_t lane) const {
    const DoubleVector all[kRaySums - 1] = {x, z, xx, xz, zz};
    for (int k = 0; k < kRaySums - 1; ++k) hwy::HWY_NAMESPACE::StoreU(all[k], Double(), sums[k + 1] + lane);
  }
};

template <bool kWeighted>
HWY_INLINE void sumRays(const Run& run, const double* origin, double (*sums)[kRunLanes]) {
  namespace hn = hwy::HWY_NAMESPACE;
  const Double d;
  const DoubleVector origin_x = hn::Set(d, origin[0]);
  const DoubleVector origin_z = hn::Set(d, origin[2]);
  const std::size_t whole = run.count - run.count % kRunLanes;
  countLanes(run.count, sums[0]);
  for (std::size_t lane = 0; lane < kRunLanes; lane += kLanes) {
    DoubleVector weights = hn::Zero(d);
    RaySums plain, weighted;
    const auto add = [&](DoubleVector weight, DoubleVector px, DoubleVector pz) HWY_ATTR {
      plain.add(px, pz, px, pz);
      if (!kWeighted) return;
      weights = hn::Add(weights, weight);
      weighted.add(hn::Mul(weight, px), hn::Mul(weight, pz), px, pz);
    };
    const auto weightAt = [&](std::size_t i) HWY_ATTR { return kWeighted ? loadFloats(run.weight + i) : hn::Zero(d); };
    const auto across = [&](std::size_t i, DoubleVector z)
                            HWY_ATTR { return hn::Sub(hn::Mul(z, hn::LoadU(d, run.across + i)), origin_x); };
    std::size_t i = lane;
    for (; i < whole; i += kRunLanes) {
      const DoubleVector z = loadFloats(run.z + i);
      add(weightAt(i), across(i, z), hn::Sub(z, origin_z));
    }
    if (i < run.count) {
      const auto is_in = lanesBelow(run.count - whole, lane);
      const DoubleVector z = loadFloats(run.z + i);
      add(hn::IfThenElseZero(is_in, weightAt(i)), hn::IfThenElseZero(is_in, across(i, z)),
          hn::IfThenElseZero(is_in, hn::Sub(z, origin_z)));
    }
    plain.store(sums, lane);
    if (!kWeighted) continue;
    hn::StoreU(weights, d, sums[kRaySums] + lane);
    weighted.store(sums + kRaySums, lane);
  }
}

/// x, y, z, xx, xy, xz, yy, yz, zz.
struct PointSums {
  DoubleVector x, y, z, xx, xy, xz, yy, yz, zz;

  HWY_INLINE PointSums() { x = y = z = xx = xy = xz = yy = yz = zz = hwy::HWY_NAMESPACE::Zero(Double()); }
  HWY_INLINE void add(DoubleVector weight_x, DoubleVector weight_y, DoubleVector weight_z, DoubleVector px,
                      DoubleVector py, DoubleVector pz) {
    namespace hn = hwy::HWY_NAMESPACE;
    x = hn::Add(x, weight_x);
    y = hn::Add(y, weight_y);
    z = hn::Add(z, weight_z);
    xx = hn::Add(xx, hn::Mul(weight_x, px));
    xy = hn::Add(xy, hn::Mul(weight_x, py));
    xz = hn::Add(xz, hn::Mul(weight_x, pz));
    yy = hn::Add(yy, hn::Mul(weight_y, py));
    yz = hn::Add(yz, hn::Mul(weight_y, pz));
    zz = hn::Add(zz, hn::Mul(weight_z, pz));
  }
  HWY_INLINE void store(double (*sums)[kRunLanes], std::size_t lane) const {
    const DoubleVector all[kSums - 1] = {x, y, z, xx, xy, xz, yy, yz, zz};
    for (int k = 0; k < kSums - 1; ++k) hwy::HWY_NAMESPACE::StoreU(all[k], Double(), sums[k + 1] + lane);
  }
};

/// Plain or weighted: both at once would not stay in registers.
template <bool kWeighted>
HWY_INLINE void sumPointsOnce(const Run& run, const double* origin, double (*sums)[kRunLanes]) {
  namespace hn = hwy::HWY_NAMESPACE;
  const Double d;
  const DoubleVector origin_x = hn::Set(d, origin[0]);
  const DoubleVector origin_y = hn::Set(d, origin[1]);
  const DoubleVector origin_z = hn::Set(d, origin[2]);
  const std::size_t whole = run.count - run.count % kRunLanes;
  if (!kWeighted) countLanes(run.count, sums[0]);
  for (std::size_t lane = 0; lane < kRunLanes; lane += kLanes) {
    DoubleVector weights = hn::Zero(d);
    PointSums all;
    const auto add = [&](DoubleVector weight, DoubleVector px, DoubleVector py, DoubleVector pz) HWY_ATTR {
      if (kWeighted) weights = hn::Add(weights, weight);
      if (kWeighted)
        all.add(hn::Mul(weight, px), hn::Mul(weight, py), hn::Mul(weight, pz), px, py, pz);
      else
        all.add(px, py, pz, px, py, pz);
    };
    std::size_t i = lane;
    for (; i < whole; i += kRunLanes)
      add(kWeighted ? loadFloats(run.weight + i) : hn::Zero(d), hn::Sub(loadFloats(run.x + i), origin_x),
          hn::Sub(loadFloats(run.y + i), origin_y), hn::Sub(loadFloats(run.z + i), origin_z));
    if (i < run.count) {
      const auto is_in = lanesBelow(run.count - whole, lane);
      add(kWeighted ? hn::IfThenElseZero(is_in, loadFloats(run.weight + i)) : hn::Zero(d),
          hn::IfThenElseZero(is_in, hn::Sub(loadFloats(run.x + i), origin_x)),
          hn::IfThenElseZero(is_in, hn::Sub(loadFloats(run.y + i), origin_y)),
          hn::IfThenElseZero(is_in, hn::Sub(loadFloats(run.z + i), origin_z)));
    }
    if (kWeighted) hn::StoreU(weights, d, sums[0] + lane);
    all.store(sums, lane);
  }
}

template <bool kWeighted>
HWY_INLINE void sumPoints(const Run& run, const double* origin, double (*sums)[kRunLanes]) {
  sumPointsOnce<false>(run, origin, sums);
  if (kWeighted) sumPointsOnce<true>(run, origin, sums + kSums);
}

#endif

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace epcc
HWY_AFTER_NAMESPACE();

#endif
