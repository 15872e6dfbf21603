// SPDX-License-Identifier: BSD-3-Clause
// Products in double precision, as DepthFrame has them pixel by pixel.
#include "depth_rows.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "depth_rows.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>
#include <limits>

#include "vector/dispatch.h"

HWY_BEFORE_NAMESPACE();
namespace epcc {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// Checked before the values are narrowed: some units narrow infinity to the largest number.
constexpr double kLargest = static_cast<double>(std::numeric_limits<float>::max());
constexpr double kLastInteger = 65534.5;  // 65535 stands for what is beyond

#if HWY_TARGET == HWY_EMU128  // the compiler makes vectors of a plain loop, but not of emulated conversions

/// z = scale * value.
template <typename Value>
HWY_INLINE void scaleDepths(const Value* values, std::size_t count, double scale, double farthest, float* depth) {
  for (std::size_t i = 0; i < count; ++i) {
    const double z = static_cast<double>(values[i]) * scale;
    depth[i] = static_cast<float>(z > 0.0 && z <= farthest ? z : 0.0);
  }
}

#else

using Doubles = hn::ScalableTag<double>;
using Halves = hn::Rebind<float, Doubles>;
constexpr std::size_t kLanes = hn::MaxLanes(Doubles());

HWY_INLINE hn::Vec<Doubles> loadValues(const std::uint16_t* values) {
  const hn::Rebind<std::int32_t, Doubles> whole;
  const hn::Rebind<std::uint16_t, Doubles> narrow;
  return hn::PromoteTo(Doubles(), hn::PromoteTo(whole, hn::LoadU(narrow, values)));
}
HWY_INLINE hn::Vec<Doubles> loadValues(const float* values) {
  return hn::PromoteTo(Doubles(), hn::LoadU(Halves(), values));
}

/// z = scale * value.
template <typename Value>
HWY_INLINE void scaleDepths(const Value* values, std::size_t count, double scale, double farthest, float* depth) {
  const Doubles d;
  const auto scales = hn::Set(d, scale);
  const auto largest = hn::Set(d, farthest);
  const auto metres = [&](const Value* from, float* to) HWY_ATTR {
    const auto z = hn::Mul(loadValues(from), scales);
    const auto valid = hn::And(hn::Gt(z, hn::Zero(d)), hn::Le(z, largest));
    hn::StoreU(hn::DemoteTo(Halves(), hn::IfThenElseZero(valid, z)), Halves(), to);
  };
  std::size_t i = 0;
  for (; i + kLanes <= count; i += kLanes) metres(values + i, depth + i);
  if (i == count) return;
  Value rest[kLanes] = {};
  float rest_depth[kLanes];
  for (std::size_t k = 0; i + k < count; ++k) rest[k] = values[i + k];
  metres(rest, rest_depth);
  for (std::size_t k = 0; i + k < count; ++k) depth[i + k] = rest_depth[k];
}

#endif

void ScaleIntegers(const std::uint16_t* values, std::size_t count, double scale, float* depth) {
  scaleDepths(values, count, scale, std::min(kLargest, kLastInteger * scale), depth);
}
void ScaleFloats(const float* values, std::size_t count, double scale, float* depth) {
  scaleDepths(values, count, scale, kLargest, depth);
}

}  // namespace HWY_NAMESPACE
}  // namespace epcc
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace epcc {

HWY_EXPORT(ScaleIntegers);
HWY_EXPORT(ScaleFloats);

void depthsInMetres(const std::uint16_t* values, std::size_t count, double scale, float* depth) {
  EPCC_KERNEL(ScaleIntegers)(values, count, scale, depth);
}

void depthsInMetres(const float* values, std::size_t count, double scale, float* depth) {
  EPCC_KERNEL(ScaleFloats)(values, count, scale, depth);
}

}  // namespace epcc
#endif
