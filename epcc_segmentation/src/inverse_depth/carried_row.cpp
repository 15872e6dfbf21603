// SPDX-License-Identifier: BSD-3-Clause
// Lane by lane a sample's point in the earlier camera, and its pixel there. Labels are not gathered in lanes: on many
// processors that is slower than one by one.
#include "inverse_depth/carried_row.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "inverse_depth/carried_row.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "vector/dispatch.h"

HWY_BEFORE_NAMESPACE();
namespace epcc {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using CarriedFloats = hn::ScalableTag<float>;
using CarriedNumbers = hn::Rebind<std::int32_t, CarriedFloats>;
constexpr int kCarriedLanes = static_cast<int>(hn::MaxLanes(CarriedFloats()));

/// Samples from `column` on; those behind `pixels` of them, which may be as many as there are lanes, are none.
struct CarriedPart {
  float w[kCarriedLanes] = {}, across[kCarriedLanes] = {};
  CarriedPart(const CarriedRow& row, int column) {
    for (int k = 0; column + k < row.width; ++k) {
      w[k] = row.w[column + k];
      across[k] = row.across[column + k];
    }
  }
};

/// The pixels of the samples at w, across; the one behind the last of those that the earlier frame does not show.
template <class Lanes, class Vector>
HWY_INLINE auto CarriedPixels(const CarriedRow& row, Lanes d, Vector w, Vector across) {
  const CarriedNumbers di;
  const auto coordinate = [&](int k) HWY_ATTR {
    const auto at_infinity = hn::Add(hn::Mul(hn::Set(d, row.along_row[k]), across), hn::Set(d, row.begin[k]));
    return hn::Add(hn::Mul(hn::Set(d, row.shift[k]), w), at_infinity);
  };
  const auto z = coordinate(2);
  const auto inverse = hn::Div(hn::Set(d, 1.0f), z);
  const auto zero = hn::Zero(d);
  const auto column =
      hn::Add(hn::Mul(hn::Set(d, row.column_factor), hn::Mul(coordinate(0), inverse)), hn::Set(d, row.column_offset));
  const auto line =
      hn::Add(hn::Mul(hn::Set(d, row.row_factor), hn::Mul(coordinate(1), inverse)), hn::Set(d, row.row_offset));
  const auto within =
      hn::And(hn::And(hn::Ge(column, zero), hn::Lt(column, hn::Set(d, static_cast<float>(row.frame_width)))),
              hn::And(hn::Ge(line, zero), hn::Lt(line, hn::Set(d, static_cast<float>(row.frame_height)))));
  const auto seen = hn::And(within, hn::And(hn::Gt(w, zero), hn::Gt(z, zero)));
  const auto whole_line = hn::ConvertTo(di, hn::IfThenElseZero(seen, line));
  const auto whole_column = hn::ConvertTo(di, hn::IfThenElseZero(seen, column));
  const auto pixel = hn::Add(hn::Mul(whole_line, hn::Set(di, row.frame_width)), whole_column);
  return hn::IfThenElse(hn::RebindMask(di, seen), pixel, hn::Set(di, row.frame_width * row.frame_height));
}

void PlacesInEarlierFrame(const CarriedRow* row, std::int32_t* pixels) {
  const CarriedFloats d;
  const CarriedNumbers di;
  int k = 0;
  for (; k + kCarriedLanes <= row->width; k += kCarriedLanes)
    hn::StoreU(CarriedPixels(*row, d, hn::LoadU(d, row->w + k), hn::LoadU(d, row->across + k)), di, pixels + k);
  if (k < row->width) {
    const CarriedPart part(*row, k);
    hn::StoreU(CarriedPixels(*row, d, hn::LoadU(d, part.w), hn::LoadU(d, part.across)), di, pixels + k);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace epcc
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace epcc {

HWY_EXPORT(PlacesInEarlierFrame);

void placesInEarlierFrame(const CarriedRow& row, std::int32_t* pixels) {
  EPCC_KERNEL(PlacesInEarlierFrame)(&row, pixels);
}

}  // namespace epcc
#endif
