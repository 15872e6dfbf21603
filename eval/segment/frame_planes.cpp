// SPDX-License-Identifier: BSD-3-Clause
// The steps between a frame and its planes.
#include "eval/segment/frame_planes.h"

#include "datasets/support/input_error.h"

namespace epcc {

FrameSensor sensorOf(const SegmentInput& input, const LabelledFrame& frame, const std::string& noise) {
  const std::string& told_by = input.camera_file.empty() ? input.path : input.camera_file;
  return frameSensor(noise, frame.camera.noise, frameView(frame), told_by);
}

void findPlanes(const SegmentInput& input, const LabelledFrame& frame, const FrameSensor& sensor,
                const Parameters& parameters, PlaneExtractor& extractor, PlaneSegmentation& result) {
  Parameters own = parameters;
  if (sensor.is_measured) own.inverse_depth.adapt_sensor = false;
  extractor.setParameters(own);
  extractor.setSensor(sensor.model);
  if (!extractor.extract(frameView(frame), result)) throw InputError(input.path, "frame", extractor.error());
  result.doubts = doubtsAbout(frame, sensor, result);
}

}  // namespace epcc
