// SPDX-License-Identifier: BSD-3-Clause
// Reads perspective clouds: the points of a row are inverted in vectors, the sums of several rows run side by side.
#include "inverse_depth/perspective_points.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "inverse_depth/perspective_points.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>

#include "inverse_depth/depth_inversion.h"
#include "vector/dispatch.h"

HWY_BEFORE_NAMESPACE();
namespace epcc {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::ScalableTag<float>;
using Doubles = hn::ScalableTag<double>;
using FloatVector = hn::Vec<Floats>;
using HalfVector = hn::Vec<hn::Half<Floats>>;
constexpr std::size_t kLanes = hn::MaxLanes(Floats());
constexpr std::size_t kHalf = hn::MaxLanes(Doubles());

/// x/z added to the columns' sums, y/z stored, and the valid points counted; in double precision.
HWY_INLINE void addSlopes(HalfVector x, HalfVector y, HalfVector z, HalfVector one, double* across, double* count,
                          double* slope) {
  const Doubles d;
  const auto inverse = hn::Div(hn::Set(d, 1.0), hn::PromoteTo(d, z));
  hn::StoreU(hn::Add(hn::LoadU(d, across), hn::Mul(hn::PromoteTo(d, x), inverse)), d, across);
  hn::StoreU(hn::Add(hn::LoadU(d, count), hn::PromoteTo(d, one)), d, count);
  hn::StoreU(hn::Mul(hn::PromoteTo(d, y), inverse), d, slope);
}

/// One vector of points, four floats apart. Returns the number of valid ones.
HWY_INLINE std::size_t invertVector(const float* xyz, float sign, float* w, double* across, double* count,
                                    double* slope) {
  const Floats d;
  const hn::Half<Floats> half;
  const auto zero = hn::Zero(d);
  const auto one = hn::Set(d, 1.0f);
  const auto farthest = hn::Set(d, kFarthestMeasured);
  FloatVector x, y, z, rest;
  hn::LoadInterleaved4(d, xyz, x, y, z, rest);
  y = hn::Mul(y, hn::Set(d, sign));
  z = hn::Mul(z, hn::Set(d, sign));
  const auto is_near = hn::And(hn::Le(hn::Abs(x), farthest), hn::Le(hn::Abs(y), farthest));
  const auto measured = hn::And(is_near, hn::And(hn::Gt(z, zero), hn::Le(z, farthest)));
  z = hn::IfThenElse(measured, z, one);
  const auto inverse = hn::Div(one, z);
  const auto valid = hn::And(measured, hn::Le(inverse, hn::Set(d, kLargestInverse)));
  hn::StoreU(hn::IfThenElseZero(valid, inverse), d, w);
  x = hn::IfThenElseZero(valid, x);
  y = hn::IfThenElseZero(valid, y);
  const auto ones = hn::IfThenElseZero(valid, one);
  addSlopes(hn::LowerHalf(half, x), hn::LowerHalf(half, y), hn::LowerHalf(half, z), hn::LowerHalf(half, ones), across,
            count, slope);
  addSlopes(hn::UpperHalf(half, x), hn::UpperHalf(half, y), hn::UpperHalf(half, z), hn::UpperHalf(half, ones),
            across + kHalf, count + kHalf, slope + kHalf);
  return hn::CountTrue(d, valid);
}

/// w = 1/z of a row, which is read up to the z of its last point.
double InvertPoints(const float* xyz, std::size_t columns, float sign, float* w, double* across, double* count,
                    double* slope) {
  std::size_t valid = 0, c = 0;
  for (; c + kLanes < columns; c += kLanes)
    valid += invertVector(xyz + 4 * c, sign, w + c, across + c, count + c, slope + c);
  float points[4 * kLanes] = {};
  float last_w[kLanes];
  double last_across[kLanes] = {}, last_count[kLanes] = {}, last_slope[kLanes];
  for (std::size_t k = 0; c + k < columns; ++k) {
    for (std::size_t i = 0; i < 3; ++i) points[4 * k + i] = xyz[4 * (c + k) + i];
    last_across[k] = across[c + k];
    last_count[k] = count[c + k];
  }
  valid += invertVector(points, sign, last_w, last_across, last_count, last_slope);
  for (std::size_t k = 0; c + k < columns; ++k) {
    w[c + k] = last_w[k];
    across[c + k] = last_across[k];
    count[c + k] = last_count[k];
    slope[c + k] = last_slope[k];
  }
  return static_cast<double>(valid);
}

}  // namespace HWY_NAMESPACE
}  // namespace epcc
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace epcc {

namespace {

HWY_EXPORT(InvertPoints);

// A sum in the order of its pixels waits for each addition; those of several rows do not wait for one another.
constexpr std::size_t kRows = 4;

/// The points of a row in the scan frame, four floats apart; z = 0, which is no point, where the mask says so. `sign`
/// is that of y and z.
void copyRow(const DepthFrame& frame, int row, float sign, float* xyz) {
  const int columns = frame.width();
  const std::size_t step = columns > 1 ? frame.index(row, 1) - frame.index(row, 0) : 0;
  const std::size_t stride = step * frame.pointStride();
  const float* point = frame.points() + frame.pointStride() * frame.index(row, 0);
  const int x = frame.isTransposed() ? 1 : 0;  // its place in the copy
  int column = 0;
  // Most points have a fourth float, and all four are copied at once; behind the last point there may be nothing.
  if (x == 0 && sign > 0.0f && frame.pointStride() >= 4)
    for (; column + 1 < columns; ++column, point += stride) std::memcpy(xyz + 4 * column, point, 4 * sizeof(float));
  for (; column < columns; ++column, point += stride) {
    xyz[4 * column + x] = point[0];
    xyz[4 * column + 1 - x] = sign * point[1];
    xyz[4 * column + 2] = sign * point[2];
  }
  if (frame.mask() == nullptr) return;
  const std::uint8_t* mask = frame.mask() + frame.index(row, 0);
  for (int masked = 0; masked < columns; ++masked, mask += step)
    if (*mask == 0) xyz[4 * masked + 2] = 0.0f;
}

void addRows(const double* slope, std::size_t columns, double* along) {
  double sum[kRows] = {};
  for (std::size_t c = 0; c < columns; ++c)
    for (std::size_t k = 0; k < kRows; ++k) sum[k] += slope[k * columns + c];
  std::copy(sum, sum + kRows, along);
}

}  // namespace

void PerspectivePoints::read(const DepthFrame& frame, std::size_t stride, float* w, double* across,
                             double* column_count, double* along, double* row_count) {
  const auto columns = static_cast<std::size_t>(frame.width());
  const auto rows = static_cast<std::size_t>(frame.height());
  const float sign = frame.projection() == Projection::PerspectiveBackward ? -1.0f : 1.0f;
  const bool in_place = frame.pointStride() == 4 && frame.mask() == nullptr && !frame.isTransposed();
  points_.resize(4 * columns);
  slope_.resize(kRows * columns);
  double sums[kRows];
  for (std::size_t first = 0; first < rows; first += kRows) {
    const std::size_t count = std::min(kRows, rows - first);
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t r = first + k;
      if (!in_place) copyRow(frame, static_cast<int>(r), sign, points_.data());
      const float* row = in_place ? frame.points() + 4 * columns * r : points_.data();
      row_count[r] = EPCC_KERNEL(InvertPoints)(row, columns, in_place ? sign : 1.0f, w + r * stride, across,
                                               column_count, slope_.data() + k * columns);
    }
    addRows(slope_.data(), columns, sums);
    std::copy(sums, sums + count, along + first);
  }
}

}  // namespace epcc
#endif
