// SPDX-License-Identifier: BSD-3-Clause
// The parts are the lanes: each adds its pixels row by row and solves its equations by itself, so that the order of no
// sum depends on the vectors.
#include "sensor/block_parts.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sensor/block_parts.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "vector/dispatch.h"
#include "vector/extremes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace epcc {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::CappedTag<float, kParts>;
using Vector = hn::Vec<Floats>;
constexpr int kLanes = static_cast<int>(hn::MaxLanes(Floats()));

/// w[y][x][part] of rows that hold four parts one after the other.
void SplitIntoParts(const BlockSamples& samples, PartPixels& parts) {
  const hn::FixedTag<float, kPartsAcross> d;
  for (int row = 0; row < samples.side; ++row) {
    const int down = row / parts.side;
    float(*to)[kParts] = parts.w + (row - down * parts.side) * parts.side;
    const float* from = samples.w + row * samples.pitch;
    for (int x = 0; x < parts.side; x += kPartsAcross) {
      const auto part0 = hn::LoadU(d, from + x);
      const auto part1 = hn::LoadU(d, from + x + parts.side);
      const auto part2 = hn::LoadU(d, from + x + 2 * parts.side);
      const auto part3 = hn::LoadU(d, from + x + 3 * parts.side);
      const auto even_low = hn::InterleaveLower(d, part0, part2);
      const auto odd_low = hn::InterleaveLower(d, part1, part3);
      const auto even_high = hn::InterleaveUpper(d, part0, part2);
      const auto odd_high = hn::InterleaveUpper(d, part1, part3);
      float* first = to[x] + down * kPartsAcross;
      hn::Store(hn::InterleaveLower(d, even_low, odd_low), d, first);
      hn::Store(hn::InterleaveUpper(d, even_low, odd_low), d, first + kParts);
      hn::Store(hn::InterleaveLower(d, even_high, odd_high), d, first + 2 * kParts);
      hn::Store(hn::InterleaveUpper(d, even_high, odd_high), d, first + 3 * kParts);
    }
  }
}

/// sums of [|e| <= gate] {x^i y^j, e x^i y^j, e^2}
void SumParts(const PartPixels& parts, float gate, PartSums& sums) {
  const Floats d;
  const Vector limit = hn::Set(d, gate);
  const Vector one = hn::Set(d, 1.0f);
  for (int lane = 0; lane < kParts; lane += kLanes) {
    Vector sum[kBlockSums];
    for (Vector& s : sum) s = hn::Zero(d);
    for (int row = 0; row < parts.side; ++row) {
      const float(*pixel)[kParts] = parts.w + row * parts.side;
      const Vector along_y = hn::Load(d, parts.along_y[row] + lane);
      Vector n = hn::Zero(d), nx = n, nxx = n, nxxx = n, nxxxx = n, ne = n, nex = n, nexx = n, nee = n;
      for (int column = 0; column < parts.side; ++column) {
        const Vector x = hn::Load(d, parts.x[column] + lane);
        const Vector said = hn::Add(hn::Load(d, parts.along_x[column] + lane), along_y);
        const Vector any_e = hn::Sub(hn::Load(d, pixel[column] + lane), said);
        const auto is_inlier = hn::Le(hn::Abs(any_e), limit);
        const Vector e = hn::IfThenElseZero(is_inlier, any_e);
        const Vector x1 = hn::IfThenElseZero(is_inlier, x);
        const Vector x2 = hn::Mul(x1, x);
        const Vector x3 = hn::Mul(x2, x);
        const Vector ex = hn::Mul(e, x);
        n = hn::Add(n, hn::IfThenElseZero(is_inlier, one));
        nx = hn::Add(nx, x1);
        nxx = hn::Add(nxx, x2);
        nxxx = hn::Add(nxxx, x3);
        nxxxx = hn::Add(nxxxx, hn::Mul(x3, x));
        ne = hn::Add(ne, e);
        nex = hn::Add(nex, ex);
        nexx = hn::Add(nexx, hn::Mul(ex, x));
        nee = hn::Add(nee, hn::Mul(e, e));
      }
      const Vector y = hn::Load(d, parts.y[row] + lane);
      const auto addPowersOfY = [&](Vector value, int i, int highest, int first) HWY_ATTR {
        for (int j = 0; j <= highest; ++j) {
          Vector& s = sum[first + termAt(i, j)];
          s = hn::Add(s, value);
          if (j < highest) value = hn::Mul(value, y);
        }
      };
      addPowersOfY(n, 0, 4, 0);
      addPowersOfY(nx, 1, 3, 0);
      addPowersOfY(nxx, 2, 2, 0);
      addPowersOfY(nxxx, 3, 1, 0);
      addPowersOfY(nxxxx, 4, 0, 0);
      addPowersOfY(ne, 0, 2, kErrorSums);
      addPowersOfY(nex, 1, 1, kErrorSums);
      addPowersOfY(nexx, 2, 0, kErrorSums);
      sum[kSquareSum] = hn::Add(sum[kSquareSum], nee);
    }
    for (int k = 0; k < kBlockSums; ++k) hn::Store(sum[k], d, sums.of[k] + lane);
  }
}

/// Sums of (x + shift)^i: one more power of the shift each time, m_i += shift m_(i-1).
template <int kHighest>
HWY_INLINE void ShiftPowers(Vector shift, const int (&place)[kHighest + 1], Vector* sum) {
  for (int pass = 1; pass <= kHighest; ++pass)
    for (int i = kHighest; i >= pass; --i) sum[place[i]] = hn::Add(sum[place[i]], hn::Mul(shift, sum[place[i - 1]]));
}

/// The sums of `count` parts in the coordinates of the parts that four of them make: x / 2 + shift.
void ShiftParts(const PartShifts& shifts, int count, PartSums& sums) {
  const Floats d;
  for (int lane = 0; lane < count; lane += kLanes) {
    Vector sum[kBlockSums];
    for (int k = 0; k < kBlockSums; ++k) sum[k] = hn::Load(d, sums.of[k] + lane);
    float scale = 0.5f;
    for (int degree = 1; degree <= 2 * kDegree; ++degree, scale *= 0.5f)
      for (int j = 0; j <= degree; ++j) {
        Vector& s = sum[termAt(degree - j, j)];
        s = hn::Mul(s, hn::Set(d, scale));
        if (degree > kDegree) continue;
        Vector& error = sum[kErrorSums + termAt(degree - j, j)];
        error = hn::Mul(error, hn::Set(d, scale));
      }
    constexpr int kE = kErrorSums;
    const Vector x = hn::Load(d, shifts.x + lane);
    ShiftPowers<4>(x, {termAt(0, 0), termAt(1, 0), termAt(2, 0), termAt(3, 0), termAt(4, 0)}, sum);
    ShiftPowers<3>(x, {termAt(0, 1), termAt(1, 1), termAt(2, 1), termAt(3, 1)}, sum);
    ShiftPowers<2>(x, {termAt(0, 2), termAt(1, 2), termAt(2, 2)}, sum);
    ShiftPowers<1>(x, {termAt(0, 3), termAt(1, 3)}, sum);
    ShiftPowers<2>(x, {kE + termAt(0, 0), kE + termAt(1, 0), kE + termAt(2, 0)}, sum);
    ShiftPowers<1>(x, {kE + termAt(0, 1), kE + termAt(1, 1)}, sum);
    const Vector y = hn::Load(d, shifts.y + lane);
    ShiftPowers<4>(y, {termAt(0, 0), termAt(0, 1), termAt(0, 2), termAt(0, 3), termAt(0, 4)}, sum);
    ShiftPowers<3>(y, {termAt(1, 0), termAt(1, 1), termAt(1, 2), termAt(1, 3)}, sum);
    ShiftPowers<2>(y, {termAt(2, 0), termAt(2, 1), termAt(2, 2)}, sum);
    ShiftPowers<1>(y, {termAt(3, 0), termAt(3, 1)}, sum);
    ShiftPowers<2>(y, {kE + termAt(0, 0), kE + termAt(0, 1), kE + termAt(0, 2)}, sum);
    ShiftPowers<1>(y, {kE + termAt(1, 0), kE + termAt(1, 1)}, sum);
    for (int k = 0; k < kBlockSums; ++k) hn::Store(sum[k], d, sums.of[k] + lane);
  }
}

/// e'e - b' A^-1 b of each part, A = L D L'; the terms of a plane come first.
void SolveParts(const PartSums& sums, int count, PartSquares& squares) {
  constexpr float kNoPivot = 1e-5f;  // of the diagonal: the term says nothing that others do not
  constexpr int kPowers[kTerms][2] = {{0, 0}, {1, 0}, {0, 1}, {2, 0}, {1, 1}, {0, 2}};
  const Floats d;
  for (int lane = 0; lane < count; lane += kLanes) {
    Vector a[kTerms][kTerms];  // the lower triangle and, last, b
    Vector b[kTerms];
    for (int i = 0; i < kTerms; ++i) {
      for (int k = 0; k <= i; ++k)
        a[i][k] = hn::Load(d, sums.of[termAt(kPowers[i][0] + kPowers[k][0], kPowers[i][1] + kPowers[k][1])] + lane);
      b[i] = hn::Load(d, sums.of[kErrorSums + termAt(kPowers[i][0], kPowers[i][1])] + lane);
    }
    Vector left = hn::Load(d, sums.of[kSquareSum] + lane);
    Vector least[kTerms];
    for (int i = 0; i < kTerms; ++i) least[i] = hn::Mul(a[i][i], hn::Set(d, kNoPivot));
    for (int k = 0; k < kTerms; ++k) {
      if (k == kPlaneTerms) hn::Store(larger(left, hn::Zero(d)), d, squares.of_plane + lane);
      const Vector pivot = a[k][k];
      const Vector inverse = hn::IfThenElseZero(hn::Gt(pivot, least[k]), hn::Div(hn::Set(d, 1.0f), pivot));
      for (int i = k + 1; i < kTerms; ++i) {
        const Vector factor = hn::Mul(a[i][k], inverse);
        for (int j = k + 1; j <= i; ++j) a[i][j] = hn::Sub(a[i][j], hn::Mul(factor, a[j][k]));
        b[i] = hn::Sub(b[i], hn::Mul(factor, b[k]));
      }
      left = hn::Sub(left, hn::Mul(hn::Mul(b[k], b[k]), inverse));
    }
    hn::Store(larger(left, hn::Zero(d)), d, squares.of_quadric + lane);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace epcc
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace epcc {

HWY_EXPORT(SplitIntoParts);
HWY_EXPORT(SumParts);
HWY_EXPORT(ShiftParts);
HWY_EXPORT(SolveParts);

void splitIntoParts(const BlockSamples& samples, PartPixels& parts) {
  EPCC_KERNEL(SplitIntoParts)(samples, parts);
}

void sumParts(const PartPixels& parts, float gate, PartSums& sums) {
  EPCC_KERNEL(SumParts)(parts, gate, sums);
}

void shiftParts(const PartShifts& shifts, int count, PartSums& sums) {
  EPCC_KERNEL(ShiftParts)(shifts, count, sums);
}

void solveParts(const PartSums& sums, int count, PartSquares& squares) {
  EPCC_KERNEL(SolveParts)(sums, count, squares);
}

}  // namespace epcc
#endif
