// SPDX-License-Identifier: BSD-3-Clause
// Hands the frame to the extractor.
#include "baselines/epcc_segmenter.h"

namespace epcc {

namespace {

bool sameModel(const SensorModel& a, const SensorModel& b) {
  return a.isPolynomial() == b.isPolynomial() && a.coefficients() == b.coefficients() &&
         a.correlationLength() == b.correlationLength();
}

}  // namespace

bool EpccSegmenter::run(const SegmenterInput& input, PlaneSegmentation& result) {
  if (!extractor_ || !sameModel(extractor_->sensor(), input.sensor)) extractor_.emplace(parameters_, input.sensor);
  return extractor_->extract(input.frame, result) || fail(extractor_->error());
}

}  // namespace epcc
