// SPDX-License-Identifier: BSD-3-Clause
// Hands the frame to the extractor.
#include "baselines/epcc_segmenter.h"

namespace epcc {

bool EpccSegmenter::run(const SegmenterInput& input, PlaneSegmentation& result) {
  Parameters parameters = parameters_;
  if (input.sensor_is_measured) parameters.inverse_depth.adapt_sensor = false;
  extractor_.setParameters(parameters);
  // Frames of a data set are no stream, unless one says so: each is measured on its own.
  if (sensor_ == SensorChoice::Measured)
    extractor_.setSensorAuto();
  else if (sensor_ == SensorChoice::Given)
    extractor_.setSensor(input.sensor);
  return extractor_.extract(input.frame, result) || fail(extractor_.error());
}

}  // namespace epcc
