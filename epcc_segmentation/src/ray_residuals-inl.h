// SPDX-License-Identifier: BSD-3-Clause
// Sums over a run of one label of what its samples are off its plane along their rays; part of kernels, compiled for
// each vector unit.
#if defined(EPCC_RAY_RESIDUALS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef EPCC_RAY_RESIDUALS_INL_H_
#undef EPCC_RAY_RESIDUALS_INL_H_
#else
#define EPCC_RAY_RESIDUALS_INL_H_
#endif

#include <hwy/highway.h>

#include <cmath>
#include <cstddef>

#include "ray_residuals.h"
#include "run_sums-inl.h"
#include "vector/extremes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace epcc {
namespace HWY_NAMESPACE {
namespace {

/// Of a run along an image row: 1, u, uu, rho, u rho, rho rho, all times the weight, and the count.
constexpr int kRowResidualSums = 7;
constexpr double kNearest = 0.5, kFarthest = 2.0;  // z over that of the plane

#if HWY_TARGET == HWY_EMU128  // the compiler makes vectors of plain loops over the lanes, but not of emulated masks

/// 1 / sigma_w^2 = 1 / (sigma_z w^2)^2 at an inverse depth, 0 for a sample that does not count.
HWY_INLINE double weightOf(const SensorVariance& v, double inverse_depth, double ratio) {
  const auto w = static_cast<float>(inverse_depth);
  const float polynomial = (v.k2 * w + v.k1) * w + v.k0;
  const float spread = polynomial > 0.0f ? polynomial : 0.0f;
  const float w2 = w * w, w4 = w2 * w2;
  const float sum = spread * spread + v.floor * w4;
  const float least = v.smallest * w4;
  const float weight = 1.0f / (sum > least ? sum : least);
  return ratio > kNearest && ratio < kFarthest ? static_cast<double>(weight) : 0.0;
}

HWY_INLINE double countOf(double ratio) {
  return ratio > kNearest && ratio < kFarthest ? 1.0 : 0.0;
}

HWY_INLINE void addRowResiduals(const Run& run, const SensorVariance& variance, double slope, double along,
                                std::size_t first, int lanes, double (*sums)[kRunLanes]) {
  for (int k = 0; k < lanes; ++k) {
    const std::size_t i = first + static_cast<std::size_t>(k);
    const double u = run.across[i];
    const double w = slope * u + along;
    const double ratio = w * static_cast<double>(run.z[i]);
    const double weight = weightOf(variance, w, ratio);
    const double rho = w * (1.0 - ratio);
    const double weight_u = weight * u, weight_rho = weight * rho;
    sums[0][k] += weight;
    sums[1][k] += weight_u;
    sums[2][k] += weight_u * u;
    sums[3][k] += weight_rho;
    sums[4][k] += weight_rho * u;
    sums[5][k] += weight_rho * rho;
    sums[6][k] += countOf(ratio);
  }
}

HWY_INLINE void addPointResiduals(const Run& run, const SensorVariance& variance, const RayPlane& plane, bool is_range,
                                  std::size_t first, int lanes, double (*sums)[kRunLanes]) {
  for (int k = 0; k < lanes; ++k) {
    const std::size_t i = first + static_cast<std::size_t>(k);
    const auto px = static_cast<double>(run.x[i]), py = static_cast<double>(run.y[i]),
               pz = static_cast<double>(run.z[i]);
    const double measured = is_range ? std::sqrt((px * px + py * py) + pz * pz) : std::fabs(pz);
    const double depth = measured > 0.0 ? measured : 1.0;
    const double inverse = 1.0 / depth;
    const double x = px * inverse, y = py * inverse, z = pz * inverse;
    const double w = (plane.theta[0] * x + plane.theta[1] * y) + plane.theta[2] * z;
    const double ratio = w * depth;
    const double weight = weightOf(variance, w, ratio);
    const double rho = w * (1.0 - ratio);
    const double wx = weight * x, wy = weight * y, wz = weight * z, weight_rho = weight * rho;
    sums[0][k] += wx * x;
    sums[1][k] += wx * y;
    sums[2][k] += wx * z;
    sums[3][k] += wy * y;
    sums[4][k] += wy * z;
    sums[5][k] += wz * z;
    sums[6][k] += weight_rho * x;
    sums[7][k] += weight_rho * y;
    sums[8][k] += weight_rho * z;
    sums[9][k] += weight_rho * rho;
    sums[10][k] += countOf(ratio);
  }
}

HWY_INLINE void sumRowResiduals(const Run& run, const SensorVariance& variance, double slope, double along,
                                double (*sums)[kRunLanes]) {
  for (int i = 0; i < kRowResidualSums; ++i)
    for (int k = 0; k < kRunLanes; ++k) sums[i][k] = 0.0;
  std::size_t i = 0;
  for (; i + kRunLanes <= run.count; i += kRunLanes) addRowResiduals(run, variance, slope, along, i, kRunLanes, sums);
  addRowResiduals(run, variance, slope, along, i, static_cast<int>(run.count - i), sums);
}

HWY_INLINE void sumPointResiduals(const Run& run, const SensorVariance& variance, const RayPlane& plane, bool is_range,
                                  double (*sums)[kRunLanes]) {
  for (int i = 0; i < kResidualSums; ++i)
    for (int k = 0; k < kRunLanes; ++k) sums[i][k] = 0.0;
  std::size_t i = 0;
  for (; i + kRunLanes <= run.count; i += kRunLanes)
    addPointResiduals(run, variance, plane, is_range, i, kRunLanes, sums);
  addPointResiduals(run, variance, plane, is_range, i, static_cast<int>(run.count - i), sums);
}

#else

using DoubleMask = hwy::HWY_NAMESPACE::Mask<Double>;

/// 1 / sigma_w^2 = 1 / (sigma_z w^2)^2 at inverse depths.
HWY_INLINE DoubleVector weightOf(const SensorVariance& v, DoubleVector inverse_depth) {
  namespace hn = hwy::HWY_NAMESPACE;
  const hn::Rebind<float, Double> d;
  const auto w = hn::DemoteTo(d, inverse_depth);
  const auto polynomial =
      hn::Add(hn::Mul(hn::Add(hn::Mul(hn::Set(d, v.k2), w), hn::Set(d, v.k1)), w), hn::Set(d, v.k0));
  const auto spread = larger(polynomial, hn::Zero(d));
  const auto w2 = hn::Mul(w, w), w4 = hn::Mul(w2, w2);
  const auto sum = hn::Add(hn::Mul(spread, spread), hn::Mul(hn::Set(d, v.floor), w4));
  const auto variance = larger(sum, hn::Mul(hn::Set(d, v.smallest), w4));
  return hn::PromoteTo(Double(), hn::Div(hn::Set(d, 1.0f), variance));
}

HWY_INLINE DoubleMask counts(DoubleVector ratio) {
  namespace hn = hwy::HWY_NAMESPACE;
  const Double d;
  return hn::And(hn::Gt(ratio, hn::Set(d, kNearest)), hn::Lt(ratio, hn::Set(d, kFarthest)));
}

/// A sum of products at a time, in registers.
template <int kCount>
struct Accumulators {
  DoubleVector sum[kCount];
  HWY_INLINE Accumulators() {
    for (auto& s : sum) s = hwy::HWY_NAMESPACE::Zero(Double());
  }
  HWY_INLINE void add(int k, DoubleVector value) { sum[k] = hwy::HWY_NAMESPACE::Add(sum[k], value); }
  HWY_INLINE void addProduct(int k, DoubleVector a, DoubleVector b) { add(k, hwy::HWY_NAMESPACE::Mul(a, b)); }
  HWY_INLINE void store(double (*sums)[kRunLanes], std::size_t lane) const {
    for (int k = 0; k < kCount; ++k) hwy::HWY_NAMESPACE::StoreU(sum[k], Double(), sums[k] + lane);
  }
};

HWY_INLINE void sumRowResiduals(const Run& run, const SensorVariance& variance, double slope, double along,
                                double (*sums)[kRunLanes]) {
  namespace hn = hwy::HWY_NAMESPACE;
  const Double d;
  const DoubleVector one = hn::Set(d, 1.0);
  for (std::size_t lane = 0; lane < kRunLanes; lane += kLanes) {
    Accumulators<kRowResidualSums> all;
    for (std::size_t i = lane; i < run.count; i += kRunLanes) {
      const auto is_in = lanesBelow(run.count - (i - lane), lane);
      const DoubleVector u = hn::IfThenElseZero(is_in, hn::LoadU(d, run.across + i));
      const DoubleVector z = hn::IfThenElseZero(is_in, loadFloats(run.z + i));
      const DoubleVector w = hn::Add(hn::Mul(hn::Set(d, slope), u), hn::Set(d, along));
      const DoubleVector ratio = hn::Mul(w, z);
      const auto does_count = counts(ratio);
      const DoubleVector weight = hn::IfThenElseZero(does_count, weightOf(variance, w));
      const DoubleVector rho = hn::Mul(w, hn::Sub(one, ratio));
      const DoubleVector weight_u = hn::Mul(weight, u), weight_rho = hn::Mul(weight, rho);
      all.add(0, weight);
      all.add(1, weight_u);
      all.addProduct(2, weight_u, u);
      all.add(3, weight_rho);
      all.addProduct(4, weight_rho, u);
      all.addProduct(5, weight_rho, rho);
      all.add(6, hn::IfThenElseZero(does_count, one));
    }
    all.store(sums, lane);
  }
}

HWY_INLINE void sumPointResiduals(const Run& run, const SensorVariance& variance, const RayPlane& plane, bool is_range,
                                  double (*sums)[kRunLanes]) {
  namespace hn = hwy::HWY_NAMESPACE;
  const Double d;
  const DoubleVector one = hn::Set(d, 1.0);
  for (std::size_t lane = 0; lane < kRunLanes; lane += kLanes) {
    Accumulators<kResidualSums> all;
    for (std::size_t i = lane; i < run.count; i += kRunLanes) {
      const auto is_in = lanesBelow(run.count - (i - lane), lane);
      const DoubleVector px = hn::IfThenElseZero(is_in, loadFloats(run.x + i));
      const DoubleVector py = hn::IfThenElseZero(is_in, loadFloats(run.y + i));
      const DoubleVector pz = hn::IfThenElseZero(is_in, loadFloats(run.z + i));
      const DoubleVector measured =
          is_range ? hn::Sqrt(hn::Add(hn::Add(hn::Mul(px, px), hn::Mul(py, py)), hn::Mul(pz, pz))) : hn::Abs(pz);
      const DoubleVector depth = hn::IfThenElse(hn::Gt(measured, hn::Zero(d)), measured, one);
      const DoubleVector inverse = hn::Div(one, depth);
      const DoubleVector x = hn::Mul(px, inverse), y = hn::Mul(py, inverse), z = hn::Mul(pz, inverse);
      const DoubleVector w =
          hn::Add(hn::Add(hn::Mul(hn::Set(d, plane.theta[0]), x), hn::Mul(hn::Set(d, plane.theta[1]), y)),
                  hn::Mul(hn::Set(d, plane.theta[2]), z));
      const DoubleVector ratio = hn::Mul(w, depth);
      const auto does_count = counts(ratio);
      const DoubleVector weight = hn::IfThenElseZero(does_count, weightOf(variance, w));
      const DoubleVector rho = hn::Mul(w, hn::Sub(one, ratio));
      const DoubleVector wx = hn::Mul(weight, x), wy = hn::Mul(weight, y), wz = hn::Mul(weight, z);
      const DoubleVector weight_rho = hn::Mul(weight, rho);
      all.addProduct(0, wx, x);
      all.addProduct(1, wx, y);
      all.addProduct(2, wx, z);
      all.addProduct(3, wy, y);
      all.addProduct(4, wy, z);
      all.addProduct(5, wz, z);
      all.addProduct(6, weight_rho, x);
      all.addProduct(7, weight_rho, y);
      all.addProduct(8, weight_rho, z);
      all.addProduct(9, weight_rho, rho);
      all.add(10, hn::IfThenElseZero(does_count, one));
    }
    all.store(sums, lane);
  }
}

#endif

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace epcc
HWY_AFTER_NAMESPACE();

#endif
