// SPDX-License-Identifier: BSD-3-Clause
// The larger and the smaller of two numbers, the same on every vector unit; part of kernels, compiled for each.
#if defined(EPCC_EXTREMES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef EPCC_EXTREMES_INL_H_
#undef EPCC_EXTREMES_INL_H_
#else
#define EPCC_EXTREMES_INL_H_
#endif

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace epcc {
namespace HWY_NAMESPACE {
namespace {

// Which of two hn::Max() takes if one is no number is left to the unit; here it is b on all, as on x86.
#if HWY_ARCH_X86 && HWY_TARGET != HWY_EMU128

/// a > b ? a : b
template <class V>
HWY_INLINE V larger(V a, V b) {
  return hwy::HWY_NAMESPACE::Max(a, b);
}

/// a < b ? a : b
template <class V>
HWY_INLINE V smaller(V a, V b) {
  return hwy::HWY_NAMESPACE::Min(a, b);
}

#else

template <class V>
HWY_INLINE V larger(V a, V b) {
  return hwy::HWY_NAMESPACE::IfThenElse(hwy::HWY_NAMESPACE::Gt(a, b), a, b);
}

template <class V>
HWY_INLINE V smaller(V a, V b) {
  return hwy::HWY_NAMESPACE::IfThenElse(hwy::HWY_NAMESPACE::Lt(a, b), a, b);
}

#if HWY_TARGET == HWY_EMU128  // whose kernels have plain loops

HWY_INLINE float larger(float a, float b) {
  return a > b ? a : b;
}

HWY_INLINE float smaller(float a, float b) {
  return a < b ? a : b;
}

#endif

#endif

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace epcc
HWY_AFTER_NAMESPACE();

#endif
