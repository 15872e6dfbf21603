// SPDX-License-Identifier: BSD-3-Clause
// Hands the frame to the extractor.
#include "baselines/epcc_segmenter.h"

#include "epcc_segmentation/sensor_estimation.h"

namespace epcc {

namespace {

bool sameModel(const SensorModel& a, const SensorModel& b) {
  return a.isPolynomial() == b.isPolynomial() && a.coefficients() == b.coefficients() &&
         a.correlationLength() == b.correlationLength();
}

}  // namespace

bool EpccSegmenter::run(const SegmenterInput& input, PlaneSegmentation& result) {
  const SensorModel sensor = sensor_ == SensorChoice::Measured ? estimateSensor(input.frame).model() : input.sensor;
  if (!extractor_ || !sameModel(extractor_->sensor(), sensor)) extractor_.emplace(parameters_, sensor);
  return extractor_->extract(input.frame, result) || fail(extractor_->error());
}

}  // namespace epcc
