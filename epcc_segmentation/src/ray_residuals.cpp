// SPDX-License-Identifier: BSD-3-Clause
// Finds the runs of one label in a row and sums each in registers.
#include "ray_residuals.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "ray_residuals.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "label_runs-inl.h"
#include "ray_residuals-inl.h"
#include "run_sums-inl.h"
#include "vector/dispatch.h"

HWY_BEFORE_NAMESPACE();
namespace epcc {
namespace HWY_NAMESPACE {
namespace {

HWY_INLINE void addFolded(const double* run, double factor, double* total) {
  for (int k = 0; k < kSumLanes; ++k) total[k] += factor * (run[k] + run[k + kSumLanes]);
}

/// The sums 1, u, uu, rho, u rho, rho rho and the count of a run along an image row, whose rays are (u, v, 1).
HWY_INLINE void addRowSums(const double (*run)[kRunLanes], double v, ResidualSums& sums) {
  addFolded(run[2], 1.0, sums.lanes[0]);
  addFolded(run[1], v, sums.lanes[1]);
  addFolded(run[1], 1.0, sums.lanes[2]);
  addFolded(run[0], v * v, sums.lanes[3]);
  addFolded(run[0], v, sums.lanes[4]);
  addFolded(run[0], 1.0, sums.lanes[5]);
  addFolded(run[4], 1.0, sums.lanes[6]);
  addFolded(run[3], v, sums.lanes[7]);
  addFolded(run[3], 1.0, sums.lanes[8]);
  addFolded(run[5], 1.0, sums.lanes[9]);
  addFolded(run[6], 1.0, sums.lanes[10]);
}

HWY_INLINE void addRun(const SampleRow& row, const SensorVariance& variance, const RayPlane& plane, std::size_t begin,
                       std::size_t end, ResidualSums& sums) {
  double own[kResidualSums][kRunLanes];
  if (row.x == nullptr) {
    const double along = plane.theta[1] * row.along + plane.theta[2];
    sumRowResiduals({end - begin, nullptr, nullptr, nullptr, row.z + begin, row.across + begin}, variance,
                    plane.theta[0], along, own);
    addRowSums(own, row.along, sums);
  } else {
    sumPointResiduals({end - begin, nullptr, row.x + begin, row.y + begin, row.z + begin, nullptr}, variance, plane,
                      row.depth_is_range, own);
    for (int k = 0; k < kResidualSums; ++k) addFolded(own[k], 1.0, sums.lanes[k]);
  }
}

void sumRow(const SampleRow& row, const SensorVariance& variance, std::int32_t label_count, const RayPlane* planes,
            ResidualSums* sums) {
  forEachRun(row.labels, row.count, [&](std::size_t begin, std::size_t end) HWY_ATTR {
    const std::int32_t label = row.labels[begin];
    if (label >= 1 && label <= label_count) addRun(row, variance, planes[label - 1], begin, end, sums[label - 1]);
  });
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

void addToResidualSums(const SampleRow& row, const SensorVariance& variance, std::int32_t label_count,
                       const RayPlane* planes, ResidualSums* sums) {
  EPCC_KERNEL(sumRow)(row, variance, label_count, planes, sums);
}

}  // namespace epcc
#endif
