// SPDX-License-Identifier: BSD-3-Clause
// Sums over the labelled pixels of a row, one set for each label, from which regions have their moments.
#pragma once

#include <cstdint>

namespace epcc {

/// Sums over pixels with the ray (a, v, f) and the inverse depth w, of weight 1/sigma_w^2 but for the first two. Rows
/// add up; v is the same in a row.
struct RaySums {
  double n = 0.0, w_plain = 0.0;
  double one = 0.0, aa = 0.0, af = 0.0, av = 0.0, fv = 0.0, vv = 0.0;
  double aw = 0.0, vw = 0.0, fw = 0.0, ww = 0.0;

  RaySums& operator+=(const RaySums& other);
  RaySums& operator-=(const RaySums& other);
};

inline RaySums& RaySums::operator+=(const RaySums& other) {
  n += other.n;
  w_plain += other.w_plain;
  one += other.one;
  aa += other.aa;
  af += other.af;
  av += other.av;
  fv += other.fv;
  vv += other.vv;
  aw += other.aw;
  vw += other.vw;
  fw += other.fw;
  ww += other.ww;
  return *this;
}

inline RaySums& RaySums::operator-=(const RaySums& other) {
  n -= other.n;
  w_plain -= other.w_plain;
  one -= other.one;
  aa -= other.aa;
  af -= other.af;
  av -= other.av;
  fv -= other.fv;
  vv -= other.vv;
  aw -= other.aw;
  vw -= other.vw;
  fw -= other.fw;
  ww -= other.ww;
  return *this;
}

/// A row of the image; f is 1 where `forward` is null.
struct LabelledRow {
  int width = 0;
  const std::int32_t* label = nullptr;  ///< 0 none
  const float* w = nullptr;
  const float* weight = nullptr;
  const double* across = nullptr;
  const double* forward = nullptr;
  double along = 0.0;
};

/// Adds a row to the sums of its labels; those of label 1 come first.
void addRow(const LabelledRow& row, RaySums* sums);

}  // namespace epcc
