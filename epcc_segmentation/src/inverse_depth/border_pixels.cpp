// SPDX-License-Identifier: BSD-3-Clause
// All that a question depends on is gathered by its pixel and its labels.
#include "inverse_depth/border_pixels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "inverse_depth/border_pixels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <cstddef>

#include "inverse_depth/noise_variance-inl.h"
#include "vector/dispatch.h"
#include "vector/extremes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace epcc {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::CappedTag<float, 16>;
using Integers = hn::Rebind<std::int32_t, Floats>;
using FloatVector = hn::Vec<Floats>;
using IntegerVector = hn::Vec<Integers>;
constexpr std::size_t kLanes = hn::MaxLanes(Floats());
constexpr int kNumbersOfPlane = sizeof(PixelPlane) / sizeof(float);

struct PlaneVectors {
  FloatVector w;                   // the plane's inverse depth at each pixel
  FloatVector inverse_root_slope;  // 1 / sqrt(slope factor)
};

/// The planes of `labels` at the rays.
HWY_INLINE PlaneVectors PlanesAt(const PixelPlane* planes, IntegerVector labels, FloatVector across, FloatVector along,
                                 FloatVector forward) {
  const Floats d;
  const float* numbers = &planes->across;
  const auto at = hn::Mul(labels, hn::Set(Integers(), kNumbersOfPlane));
  const auto sum =
      hn::Add(hn::Mul(hn::GatherIndex(d, numbers, at), across), hn::Mul(hn::GatherIndex(d, numbers + 1, at), along));
  return {hn::Add(sum, hn::Mul(hn::GatherIndex(d, numbers + 2, at), forward)), hn::GatherIndex(d, numbers + 4, at)};
}

void DecideBorderPixels(const BorderPixels* pixels, const BorderQuestions::Arrays* asked, std::int32_t* labels,
                        long* counts) {
  const Floats d;
  const Integers di;
  const BorderPixels& image = *pixels;
  const NoiseVectors<Floats> noise(d, *image.noise);
  const auto zero = hn::Zero(d);
  const auto range = hn::Set(d, image.crease_range);
  for (std::size_t i = 0; i < asked->count; i += kLanes) {
    const auto row = hn::LoadU(di, asked->rows + i);
    const auto column = hn::LoadU(di, asked->columns + i);
    const auto pixel = hn::Add(hn::Mul(row, hn::Set(di, image.width)), column);
    const auto own = hn::LoadU(di, asked->owns + i);
    const auto other = hn::LoadU(di, asked->others + i);
    const auto side = hn::LoadU(d, asked->sides + i);
    const auto current = hn::GatherIndex(di, labels, pixel);
    const auto w = hn::GatherIndex(d, image.w, pixel);
    const auto across = hn::GatherIndex(d, image.rays.across, column);
    const auto along = hn::GatherIndex(d, image.rays.along, row);
    const auto forward = hn::GatherIndex(d, image.rays.forward, column);
    const auto scale = hn::GatherIndex(d, image.scale, row);
    const auto inverse_sigma = hn::Div(scale, hn::Sqrt(noise.variance(hn::Mul(w, scale))));
    const PlaneVectors mine = PlanesAt(image.planes, current, across, along, forward);
    const PlaneVectors theirs = PlanesAt(image.planes, other, across, along, forward);
    const auto my_error = hn::Mul(hn::Mul(hn::Abs(hn::Sub(w, mine.w)), inverse_sigma), mine.inverse_root_slope);
    const auto their_error = hn::Mul(hn::Mul(hn::Abs(hn::Sub(w, theirs.w)), inverse_sigma), theirs.inverse_root_slope);
    const auto difference = hn::Sub(mine.w, theirs.w);
    const auto labelled = hn::RebindMask(d, hn::Gt(current, hn::Zero(di)));
    const auto limit =
        hn::IfThenElse(labelled, hn::Sub(my_error, hn::Set(d, image.flip_gain)), hn::Set(d, image.max_residual));
    const auto better = hn::Lt(their_error, limit);
    const auto near = hn::And(hn::Lt(larger(my_error, their_error), range),
                              hn::Lt(hn::Mul(hn::Abs(difference), inverse_sigma), range));
    const auto own_label = hn::And(labelled, hn::RebindMask(d, hn::Eq(current, own)));
    const auto crease = hn::And(hn::And(own_label, near), hn::Ne(side, zero));
    const auto beyond = hn::And(hn::Lt(hn::Mul(difference, side), zero),
                                hn::Lt(their_error, hn::Add(my_error, hn::Set(d, image.crease_slack))));
    const auto change = hn::And(hn::Gt(w, zero), hn::Or(hn::And(crease, beyond), hn::AndNot(crease, better)));
    alignas(64) std::int32_t label[kLanes], place[kLanes];
    hn::Store(hn::IfThenElse(hn::RebindMask(di, change), other, current), di, label);
    hn::Store(pixel, di, place);
    for (std::size_t k = 0; k < kLanes && i + k < asked->asked; ++k) {
      --counts[labels[place[k]]];
      ++counts[label[k]];
      labels[place[k]] = label[k];
    }
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace epcc
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace epcc {

HWY_EXPORT(DecideBorderPixels);

// rows_, whose size is asked for, grows last: if memory runs out before, the next frame tries again.
void BorderQuestions::grow(std::size_t size) {
  for (std::vector<std::int32_t>* numbers : {&columns_, &owns_, &others_}) numbers->resize(size);
  sides_.resize(size);
  rows_.resize(size);
}

BorderQuestions::Arrays BorderQuestions::filledUp() {
  makeRoom(0);
  const std::size_t whole = (count_ + kMostLanes - 1) / kMostLanes * kMostLanes;
  for (std::size_t i = count_; i < whole; ++i) {
    for (std::vector<std::int32_t>* numbers : {&rows_, &columns_, &owns_, &others_})
      (*numbers)[i] = (*numbers)[count_ - 1];
    sides_[i] = sides_[count_ - 1];
  }
  return {whole, count_, rows_.data(), columns_.data(), owns_.data(), others_.data(), sides_.data()};
}

void decideBorderPixels(const BorderPixels& image, BorderQuestions& questions, std::int32_t* labels, long* pixels) {
  const BorderQuestions::Arrays arrays = questions.filledUp();
  EPCC_KERNEL(DecideBorderPixels)(&image, &arrays, labels, pixels);
  questions.clear();
}

}  // namespace epcc
#endif
