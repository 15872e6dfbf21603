// SPDX-License-Identifier: BSD-3-Clause
// Hands the frame to the extractor.
#include "baselines/epcc_segmenter.h"

namespace epcc {

bool EpccSegmenter::run(const SegmenterInput& input, PlaneSegmentation& result) {
  // Frames of a data set are no stream: each is measured on its own.
  if (sensor_ == SensorChoice::Measured)
    extractor_.setSensorAuto();
  else
    extractor_.setSensor(input.sensor);
  return extractor_.extract(input.frame, result) || fail(extractor_.error());
}

}  // namespace epcc
