// SPDX-License-Identifier: BSD-3-Clause
// Columns of the block are lanes, and each adds its rows from top to bottom: the order does not depend on the vectors.
#include "sensor/block_kernels.h"

#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sensor/block_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "vector/dispatch.h"

HWY_BEFORE_NAMESPACE();
namespace epcc {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::CappedTag<float, kRowOfVector>;
using Vector = hn::Vec<Floats>;

constexpr int kLanes = static_cast<int>(hn::MaxLanes(Floats()));

/// e = w - ((x plane.x + forward plane.forward) + y plane.y) of the columns from `column` on.
class Residuals {
 public:
  HWY_INLINE Residuals(const BlockSamples& samples, const BlockRays& rays, const SamplePlane& plane, int column)
      : w_(samples.w + column),
        y_(rays.y),
        pitch_(samples.pitch),
        along_y_(plane.y),
        along_columns_(hn::Add(hn::Mul(hn::Set(Floats(), plane.x), hn::Load(Floats(), rays.x + column)),
                               hn::Mul(hn::Set(Floats(), plane.forward), hn::Load(Floats(), rays.forward + column)))) {}

  HWY_INLINE float y(int row) const { return y_[row]; }
  HWY_INLINE Vector e(int row) const {
    return hn::Sub(hn::Load(Floats(), w_ + row * pitch_),
                   hn::Add(along_columns_, hn::Set(Floats(), along_y_ * y_[row])));
  }

 private:
  const float* w_;
  const float* y_;
  int pitch_;
  float along_y_;
  Vector along_columns_;
};

/// w, or kNowhere where it is not above 0. Nothing beyond the block is read.
void Gather(const float* first, std::size_t row_pitch, BlockSamples& samples) {
  const Floats d;
  const Vector zero = hn::Zero(d);
  const Vector one = hn::Set(d, 1.0f);
  const Vector nowhere = hn::Set(d, kNowhere);
  Vector valid = zero;
  int valid_beside = 0;
  for (int y = 0; y < samples.side; ++y) {
    const float* pixel = first + static_cast<std::size_t>(y) * row_pitch;
    float* row = samples.w + y * samples.pitch;
    int x = 0;
    for (; x + kLanes <= samples.side; x += kLanes) {
      const Vector w = hn::LoadU(d, pixel + x);
      const auto has_depth = hn::Gt(w, zero);
      valid = hn::Add(valid, hn::IfThenElseZero(has_depth, one));
      hn::Store(hn::IfThenElse(has_depth, w, nowhere), d, row + x);
    }
    for (; x < samples.side; ++x) {
      const bool has_depth = pixel[x] > 0.0f;
      row[x] = has_depth ? pixel[x] : kNowhere;
      valid_beside += has_depth ? 1 : 0;
    }
    for (; x < samples.pitch; ++x) row[x] = kNowhere;
  }
  for (int i = 0; i < kRowOfVector; i += kLanes) hn::Store(nowhere, d, samples.w + samples.side * samples.pitch + i);
  samples.valid = valid_beside + static_cast<int>(hn::GetLane(hn::SumOfLanes(d, valid)));
}

void Subtract(float centre, const BlockRays& rays, BlockSamples& samples) {
  const Floats d;
  for (int column = 0; column < samples.pitch; column += kLanes) {
    const Vector of_column = hn::Mul(hn::Set(d, centre), hn::Load(d, rays.forward + column));
    for (int row = 0; row < samples.side; ++row) {
      float* w = samples.w + row * samples.pitch + column;
      hn::Store(hn::Sub(hn::Load(d, w), of_column), d, w);
    }
  }
}

/// sum of [|e| <= gate] {1, y, y^2, e, e y}
void SumInliers(const BlockSamples& samples, const BlockRays& rays, const SamplePlane& plane, float gate,
                ColumnSums& sums) {
  const Floats d;
  const Vector limit = hn::Set(d, gate);
  const Vector one = hn::Set(d, 1.0f);
  for (int column = 0; column < samples.side; column += kLanes) {
    const Residuals residuals(samples, rays, plane, column);
    Vector n = hn::Zero(d), ny = hn::Zero(d), nyy = hn::Zero(d), ne = hn::Zero(d), ney = hn::Zero(d);
    for (int row = 0; row < samples.side; ++row) {
      const Vector e = residuals.e(row);
      const Vector y = hn::Set(d, residuals.y(row));
      const auto inlier = hn::Le(hn::Abs(e), limit);
      const Vector inlier_e = hn::IfThenElseZero(inlier, e);
      const Vector inlier_y = hn::IfThenElseZero(inlier, y);
      n = hn::Add(n, hn::IfThenElseZero(inlier, one));
      ny = hn::Add(ny, inlier_y);
      nyy = hn::Add(nyy, hn::Mul(inlier_y, y));
      ne = hn::Add(ne, inlier_e);
      ney = hn::Add(ney, hn::Mul(inlier_e, y));
    }
    hn::Store(n, d, sums.n + column);
    hn::Store(ny, d, sums.y + column);
    hn::Store(nyy, d, sums.yy + column);
    hn::Store(ne, d, sums.e + column);
    hn::Store(ney, d, sums.ey + column);
  }
}

/// How many of `count` sizes are at most `limit`; whole numbers, exact in any order.
HWY_INLINE int CountUpTo(const float* size, int count, float limit) {
  const Floats d;
  const Vector one = hn::Set(d, 1.0f);
  const Vector most = hn::Set(d, limit);
  Vector even = hn::Zero(d), odd = hn::Zero(d);
  int i = 0;
  for (; i + 2 * kLanes <= count; i += 2 * kLanes) {
    even = hn::Add(even, hn::IfThenElseZero(hn::Le(hn::Load(d, size + i), most), one));
    odd = hn::Add(odd, hn::IfThenElseZero(hn::Le(hn::Load(d, size + i + kLanes), most), one));
  }
  for (; i < count; i += kLanes) even = hn::Add(even, hn::IfThenElseZero(hn::Le(hn::Load(d, size + i), most), one));
  return static_cast<int>(hn::GetLane(hn::SumOfLanes(d, hn::Add(even, odd))));
}

/// Halvings of an interval of the logarithm that is 24 octaves wide: what single precision tells.
void ResidualOfRank(const BlockSamples& samples, const BlockRays& rays, const SamplePlane& plane, int rank,
                    float largest, float& result) {
  constexpr int kHalvings = 12;
  const Floats d;
  alignas(64) float size[kMaxBlockPixels];
  int count = 0;
  for (int column = 0; column < samples.side; column += kLanes) {
    const Residuals residuals(samples, rays, plane, column);
    for (int row = 0; row < samples.side; ++row, count += kLanes) hn::Store(hn::Abs(residuals.e(row)), d, size + count);
  }
  float high = largest;
  float half = 1.0f / 4096.0f;
  for (int step = 0; step < kHalvings; ++step) {
    const float middle = high * half;
    if (CountUpTo(size, count, middle) > rank) high = middle;
    half = std::sqrt(half);
  }
  result = high;
}

/// What is beside the last of a row is the first of the next, as good as any, or nowhere.
/// min of [|w[x] - w[x + 1]| > rounding w[x]] |w[x] - w[x + 1]| over the pixels with depth, in any order
void SmallestStep(const BlockSamples& samples, float& result) {
  constexpr float kRounding = 1e-6f;  // relative, of single precision
  const Floats d;
  const Vector none = hn::Set(d, kNowhere);
  Vector smallest = none;
  for (int row = 0; row < samples.side; ++row) {
    const float* w = samples.w + row * samples.pitch;
    for (int x = 0; x < samples.side - 1; x += kLanes) {
      const Vector here = hn::Load(d, w + x);
      const Vector step = hn::Abs(hn::Sub(hn::LoadU(d, w + x + 1), here));
      smallest = hn::Min(smallest, hn::IfThenElse(hn::Gt(step, hn::Mul(here, hn::Set(d, kRounding))), step, none));
    }
  }
  result = hn::GetLane(hn::MinOfLanes(d, smallest));
}

}  // namespace HWY_NAMESPACE
}  // namespace epcc
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace epcc {

HWY_EXPORT(Gather);
HWY_EXPORT(Subtract);
HWY_EXPORT(SumInliers);
HWY_EXPORT(ResidualOfRank);
HWY_EXPORT(SmallestStep);

void gatherBlock(const float* first, std::size_t row_pitch, int side, BlockSamples& samples) {
  samples.setSide(side);
  EPCC_KERNEL(Gather)(first, row_pitch, samples);
}

void subtractCentre(float centre, const BlockRays& rays, BlockSamples& samples) {
  EPCC_KERNEL(Subtract)(centre, rays, samples);
}

void sumInliers(const BlockSamples& samples, const BlockRays& rays, const SamplePlane& plane, float gate,
                ColumnSums& sums) {
  EPCC_KERNEL(SumInliers)(samples, rays, plane, gate, sums);
}

float residualOfRank(const BlockSamples& samples, const BlockRays& rays, const SamplePlane& plane, int rank,
                     float largest) {
  float result = 0.0f;
  EPCC_KERNEL(ResidualOfRank)(samples, rays, plane, rank, largest, result);
  return result;
}

float smallestStep(const BlockSamples& samples) {
  float result = 0.0f;
  EPCC_KERNEL(SmallestStep)(samples, result);
  return result < 0.5f * kNowhere ? result : 0.0f;
}

}  // namespace epcc
#endif
