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

/// e = w - (x tilt_x + (y tilt_y + value)) of the columns from `column` on.
class Residuals {
 public:
  HWY_INLINE Residuals(const BlockSamples& samples, const SamplePlane& plane, int column)
      : w_(samples.w + column),
        pitch_(samples.pitch),
        middle_(0.5f * static_cast<float>(samples.side - 1)),
        tilt_y_(plane.tilt_y),
        value_(plane.value),
        along_x_(hn::Mul(hn::Set(Floats(), plane.tilt_x), hn::Iota(Floats(), static_cast<float>(column) - middle_))) {}

  HWY_INLINE float y(int row) const { return static_cast<float>(row) - middle_; }
  HWY_INLINE Vector w(int row) const { return hn::Load(Floats(), w_ + row * pitch_); }
  HWY_INLINE Vector e(int row) const {
    return hn::Sub(w(row), hn::Add(along_x_, hn::Set(Floats(), tilt_y_ * y(row) + value_)));
  }

 private:
  const float* w_;
  int pitch_;
  float middle_;
  float tilt_y_;
  float value_;
  Vector along_x_;
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
  samples.valid = valid_beside + static_cast<int>(hn::GetLane(hn::SumOfLanes(d, valid)));
}

void Subtract(float centre, BlockSamples& samples) {
  const Floats d;
  for (int i = 0; i < samples.side * samples.pitch; i += kLanes)
    hn::Store(hn::Sub(hn::Load(d, samples.w + i), hn::Set(d, centre)), d, samples.w + i);
}

/// sum of [|e| <= gate] {1, y, y^2, e, e y}
void SumInliers(const BlockSamples& samples, const SamplePlane& plane, float gate, ColumnSums& sums) {
  const Floats d;
  const Vector limit = hn::Set(d, gate);
  const Vector one = hn::Set(d, 1.0f);
  for (int column = 0; column < samples.side; column += kLanes) {
    const Residuals residuals(samples, plane, column);
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
void ResidualOfRank(const BlockSamples& samples, const SamplePlane& plane, int rank, float largest, float& result) {
  constexpr int kHalvings = 12;
  const Floats d;
  alignas(64) float size[kMaxBlockPixels];
  int count = 0;
  for (int column = 0; column < samples.side; column += kLanes) {
    const Residuals residuals(samples, plane, column);
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

/// e [|e| <= gate], and the sums of [|e| <= gate] {1, w, e^2}
void ResidualsOf(const BlockSamples& samples, const SamplePlane& plane, float gate, BlockErrors& errors,
                 ErrorSums& sums) {
  constexpr int kPitch = BlockErrors::kRowPitch;
  const Floats d;
  const Vector limit = hn::Set(d, gate);
  const Vector one = hn::Set(d, 1.0f);
  const Vector zero = hn::Zero(d);
  errors.side = samples.side;
  errors.width = samples.pitch;
  for (int column = 0; column < samples.pitch; column += kLanes) {
    const Residuals residuals(samples, plane, column);
    Vector n = zero, nw = zero, nee = zero;
    for (int row = 0; row < samples.side; ++row) {
      const Vector e = residuals.e(row);
      const auto is_inlier = hn::Le(hn::Abs(e), limit);
      const Vector error = hn::IfThenElseZero(is_inlier, e);
      const Vector inlier = hn::IfThenElseZero(is_inlier, one);
      n = hn::Add(n, inlier);
      nw = hn::Add(nw, hn::IfThenElseZero(is_inlier, residuals.w(row)));
      nee = hn::Add(nee, hn::Mul(error, error));
      hn::Store(error, d, errors.e + row * kPitch + column);
      hn::Store(inlier, d, errors.inlier + row * kPitch + column);
    }
    hn::Store(n, d, sums.n + column);
    hn::Store(nw, d, sums.w + column);
    hn::Store(nee, d, sums.ee + column);
    for (int row = samples.side; row < samples.side + kMaxLag; ++row) {
      hn::Store(zero, d, errors.e + row * kPitch + column);
      hn::Store(zero, d, errors.inlier + row * kPitch + column);
    }
  }
  for (int row = 0; row < samples.side; ++row)
    for (int column = samples.pitch; column < samples.pitch + kRowOfVector; column += kLanes) {
      hn::Store(zero, d, errors.e + row * kPitch + column);
      hn::Store(zero, d, errors.inlier + row * kPitch + column);
    }
}

/// Adds f(row, x) f(row, x + lag) + f(row, x) f(row + lag, x).
template <int kLag>
HWY_INLINE void AddProducts(const float* f, Vector here, Vector& sum) {
  const Floats d;
  const Vector right = hn::Mul(here, hn::LoadU(d, f + kLag));
  const Vector below = hn::Mul(here, hn::Load(d, f + kLag * BlockErrors::kRowPitch));
  sum = hn::Add(sum, hn::Add(right, below));
}

/// Per column: the products at kLags of f = e or f = inlier.
HWY_INLINE void SumProducts(const float* f, int side, int width, float* sums) {
  const Floats d;
  for (int column = 0; column < width; column += kLanes) {
    Vector lag1 = hn::Zero(d), lag2 = hn::Zero(d), lag4 = hn::Zero(d), lag8 = hn::Zero(d);
    for (int row = 0; row < side; ++row) {
      const float* at = f + row * BlockErrors::kRowPitch + column;
      const Vector here = hn::Load(d, at);
      AddProducts<kLags[0]>(at, here, lag1);
      AddProducts<kLags[1]>(at, here, lag2);
      AddProducts<kLags[2]>(at, here, lag4);
      AddProducts<kLags[3]>(at, here, lag8);
    }
    hn::Store(lag1, d, sums + column);
    hn::Store(lag2, d, sums + kMaxBlock + column);
    hn::Store(lag4, d, sums + 2 * kMaxBlock + column);
    hn::Store(lag8, d, sums + 3 * kMaxBlock + column);
  }
}

/// `products` and `pairs` have kMaxBlock columns for each lag.
void SumLags(const BlockErrors& errors, float* products, float* pairs) {
  SumProducts(errors.e, errors.side, errors.width, products);
  SumProducts(errors.inlier, errors.side, errors.width, pairs);
}

/// min of [v[i] - v[i - 1] > rounding v[i]] (v[i] - v[i - 1]), in any order
void SmallestGap(const float* ordered, int count, float& result) {
  constexpr float kRounding = 1e-6f;  // relative, of single precision
  const Floats d;
  const Vector none = hn::Set(d, hwy::HighestValue<float>());
  Vector smallest = none;
  int i = 1;
  for (; i + kLanes <= count; i += kLanes) {
    const Vector value = hn::LoadU(d, ordered + i);
    const Vector gap = hn::Sub(value, hn::LoadU(d, ordered + i - 1));
    smallest = hn::Min(smallest, hn::IfThenElse(hn::Gt(gap, hn::Mul(value, hn::Set(d, kRounding))), gap, none));
  }
  result = hn::GetLane(hn::MinOfLanes(d, smallest));
  for (; i < count; ++i) {
    const float gap = ordered[i] - ordered[i - 1];
    if (gap > ordered[i] * kRounding && gap < result) result = gap;
  }
  if (result == hwy::HighestValue<float>()) result = 0.0f;
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
HWY_EXPORT(ResidualsOf);
HWY_EXPORT(SumLags);
HWY_EXPORT(SmallestGap);

void gatherBlock(const float* first, std::size_t row_pitch, int side, BlockSamples& samples) {
  samples.setSide(side);
  EPCC_KERNEL(Gather)(first, row_pitch, samples);
}

void subtractCentre(float centre, BlockSamples& samples) {
  samples.centre = centre;
  EPCC_KERNEL(Subtract)(centre, samples);
}

void sumInliers(const BlockSamples& samples, const SamplePlane& plane, float gate, ColumnSums& sums) {
  EPCC_KERNEL(SumInliers)(samples, plane, gate, sums);
}

float residualOfRank(const BlockSamples& samples, const SamplePlane& plane, int rank, float largest) {
  float result = 0.0f;
  EPCC_KERNEL(ResidualOfRank)(samples, plane, rank, largest, result);
  return result;
}

void residualsOf(const BlockSamples& samples, const SamplePlane& plane, float gate, BlockErrors& errors,
                 ErrorSums& sums) {
  EPCC_KERNEL(ResidualsOf)(samples, plane, gate, errors, sums);
}

LagSums sumLags(const BlockErrors& errors) {
  alignas(64) float products[kLags.size()][kMaxBlock];
  alignas(64) float pairs[kLags.size()][kMaxBlock];
  EPCC_KERNEL(SumLags)(errors, products[0], pairs[0]);
  LagSums sums;
  for (std::size_t k = 0; k < kLags.size(); ++k)
    for (int column = 0; column < errors.width; ++column) {
      sums.products[k] += static_cast<double>(products[k][column]);
      sums.pairs[k] += static_cast<double>(pairs[k][column]);
    }
  return sums;
}

float smallestGap(const float* ordered, int count) {
  float result = 0.0f;
  EPCC_KERNEL(SmallestGap)(ordered, count, result);
  return result;
}

}  // namespace epcc
#endif
