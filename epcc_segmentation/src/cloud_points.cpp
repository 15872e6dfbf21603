// SPDX-License-Identifier: BSD-3-Clause
// Points are transposed four at a time; then whole vectors of them are checked.
#include "cloud_points.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cloud_points.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <cmath>
#include <limits>
#include <utility>

#include "vector/dispatch.h"

HWY_BEFORE_NAMESPACE();
namespace epcc {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
namespace {

HWY_INLINE void splitRow(const float* from, const PointGrid& grid, float* x, float* y, float* z) {
  const std::size_t step = grid.column_step;
  std::size_t i = 0;
#if HWY_TARGET != HWY_EMU128
  const hn::CappedTag<float, 4> d;
  const hn::Repartition<double, decltype(d)> pairs;
  for (; grid.has_fourth && i + 4 <= grid.columns; i += 4, from += 4 * step) {
    const auto a = hn::LoadU(d, from);
    const auto b = hn::LoadU(d, from + step);
    const auto c = hn::LoadU(d, from + 2 * step);
    const auto e = hn::LoadU(d, from + 3 * step);
    const auto ab = hn::BitCast(pairs, hn::InterleaveLower(d, a, b));
    const auto ce = hn::BitCast(pairs, hn::InterleaveLower(d, c, e));
    const auto ab_z = hn::BitCast(pairs, hn::InterleaveUpper(d, a, b));
    const auto ce_z = hn::BitCast(pairs, hn::InterleaveUpper(d, c, e));
    hn::StoreU(hn::BitCast(d, hn::InterleaveLower(pairs, ab, ce)), d, x + i);
    hn::StoreU(hn::BitCast(d, hn::InterleaveUpper(pairs, ab, ce)), d, y + i);
    hn::StoreU(hn::BitCast(d, hn::InterleaveLower(pairs, ab_z, ce_z)), d, z + i);
  }
#endif
  for (; i < grid.columns; ++i, from += step) {
    x[i] = from[0];
    y[i] = from[1];
    z[i] = from[2];
  }
}

void splitPoints(const PointGrid* grid, const PointArrays* to) {
  for (std::size_t row = 0; row < grid->rows; ++row)
    splitRow(grid->first + row * grid->row_step, *grid, to->x + row * to->pitch, to->y + row * to->pitch,
             to->z + row * to->pitch);
}

#if HWY_TARGET == HWY_EMU128  // the compiler makes vectors of a plain loop, but not of emulated masks

void checkPoints(const PointCheck* check, std::size_t count, float* xs, float* ys, float* zs) {
  const PointCheck is = *check;
  for (std::size_t i = 0; i < count; ++i) {
    const float x = std::abs(xs[i]), y = std::abs(ys[i]), z = std::abs(zs[i]);
    const float depth = is.forward != 0.0f ? is.forward * zs[i] : (x > 0.0f ? x : (y > 0.0f ? y : z));
    const bool valid = (x <= is.farthest) & (y <= is.farthest) & (z <= is.farthest) & (depth > 0.0f);
    xs[i] = valid ? is.sign[0] * xs[i] : 0.0f;
    ys[i] = valid ? is.sign[1] * ys[i] : 0.0f;
    zs[i] = valid ? is.sign[2] * zs[i] : 0.0f;
  }
}

#else

using Floats = hn::ScalableTag<float>;
constexpr std::size_t kLanes = hn::MaxLanes(Floats());

HWY_INLINE void checkVector(const PointCheck& check, float* xs, float* ys, float* zs) {
  const Floats d;
  const auto zero = hn::Zero(d);
  const auto farthest = hn::Set(d, check.farthest);
  const auto x = hn::LoadU(d, xs), y = hn::LoadU(d, ys), z = hn::LoadU(d, zs);
  const auto near_x = hn::Le(hn::Abs(x), farthest);
  const auto near_y = hn::Le(hn::Abs(y), farthest);
  const auto near_z = hn::Le(hn::Abs(z), farthest);
  const auto is_near = hn::And(hn::And(near_x, near_y), near_z);
  const auto in_front = hn::Gt(hn::Mul(hn::Set(d, check.forward), z), zero);
  const auto elsewhere = hn::Or(hn::Or(hn::Ne(x, zero), hn::Ne(y, zero)), hn::Ne(z, zero));
  const auto valid = hn::And(is_near, check.forward != 0.0f ? in_front : elsewhere);
  hn::StoreU(hn::IfThenElseZero(valid, hn::Mul(hn::Set(d, check.sign[0]), x)), d, xs);
  hn::StoreU(hn::IfThenElseZero(valid, hn::Mul(hn::Set(d, check.sign[1]), y)), d, ys);
  hn::StoreU(hn::IfThenElseZero(valid, hn::Mul(hn::Set(d, check.sign[2]), z)), d, zs);
}

void checkPoints(const PointCheck* check, std::size_t count, float* x, float* y, float* z) {
  const PointCheck is = *check;
  std::size_t i = 0;
  for (; i + kLanes <= count; i += kLanes) checkVector(is, x + i, y + i, z + i);
  if (i == count) return;
  float last[3][kLanes] = {};
  for (std::size_t k = 0; i + k < count; ++k) {
    last[0][k] = x[i + k];
    last[1][k] = y[i + k];
    last[2][k] = z[i + k];
  }
  checkVector(is, last[0], last[1], last[2]);
  for (std::size_t k = 0; i + k < count; ++k) {
    x[i + k] = last[0][k];
    y[i + k] = last[1][k];
    z[i + k] = last[2][k];
  }
}

#endif

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace epcc
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace epcc {

namespace {

HWY_EXPORT(splitPoints);
HWY_EXPORT(checkPoints);

void dropMasked(const DepthFrame& cloud, const CloudPart& part, const PointArrays& points) {
  for (int row = 0; row < part.rows; ++row)
    for (int i = 0; i < part.columns; ++i) {
      if (cloud.mask()[cloud.index(part.row + row, part.column + i * part.step)] != 0) continue;
      const std::size_t at = static_cast<std::size_t>(row) * points.pitch + static_cast<std::size_t>(i);
      points.x[at] = points.y[at] = points.z[at] = 0.0f;
    }
}

/// x, y and z as the cloud has them go to where `to` says.
void read(const DepthFrame& cloud, const CloudPart& part, const PointCheck& check, const PointArrays& to) {
  const std::size_t stride = cloud.pointStride();
  const std::size_t across = cloud.index(0, 1) - cloud.index(0, 0);
  const std::size_t along = cloud.index(1, 0) - cloud.index(0, 0);
  const auto rows = static_cast<std::size_t>(part.rows);
  PointGrid grid;
  grid.first = cloud.points() + stride * cloud.index(part.row, part.column);
  grid.columns = static_cast<std::size_t>(part.columns);
  grid.row_step = stride * along;
  grid.column_step = stride * across * static_cast<std::size_t>(part.step);
  grid.has_fourth = true;
  grid.rows = rows - 1;  // behind the last point of the cloud there may be nothing
  EPCC_KERNEL(splitPoints)(&grid, &to);
  const std::size_t last = rows - 1;
  const PointArrays last_to{to.x + last * to.pitch, to.y + last * to.pitch, to.z + last * to.pitch, to.pitch};
  grid.first += last * grid.row_step;
  grid.rows = 1;
  const auto pixels = static_cast<std::size_t>(cloud.width()) * static_cast<std::size_t>(cloud.height());
  grid.has_fourth = cloud.index(part.row + part.rows - 1, part.column + (part.columns - 1) * part.step) + 1 < pixels;
  EPCC_KERNEL(splitPoints)(&grid, &last_to);
  if (cloud.mask() != nullptr) dropMasked(cloud, part, to);
  EPCC_KERNEL(checkPoints)(&check, last * to.pitch + grid.columns, to.x, to.y, to.z);
}

float forwardOf(Projection projection) {
  return projection == Projection::Spherical ? 0.0f : projection == Projection::Perspective ? 1.0f : -1.0f;
}

}  // namespace

void readPoints(const DepthFrame& cloud, const CloudPart& part, const PointArrays& points) {
  constexpr float kLargest = std::numeric_limits<float>::max();
  read(cloud, part, {forwardOf(cloud.projection()), kLargest, {1.0f, 1.0f, 1.0f}}, points);
}

// As DepthFrame::scanPoint().
void readScanPoints(const DepthFrame& cloud, const CloudPart& part, float farthest, const PointArrays& points) {
  PointArrays scan = points;
  if (cloud.isTransposed()) std::swap(scan.x, scan.y);
  const float forward = forwardOf(cloud.projection());
  switch (cloud.projection()) {
    case Projection::Perspective:
      return read(cloud, part, {forward, farthest, {1.0f, 1.0f, 1.0f}}, scan);
    case Projection::PerspectiveBackward:
      return read(cloud, part, {forward, farthest, {1.0f, -1.0f, -1.0f}}, scan);
    case Projection::Spherical:  // x forward, y left, z up
      return read(cloud, part, {forward, farthest, {1.0f, -1.0f, -1.0f}}, {scan.z, scan.x, scan.y, scan.pitch});
  }
}

}  // namespace epcc
#endif
